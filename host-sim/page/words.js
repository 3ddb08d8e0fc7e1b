// Numbers in words: what to do about an alarm or an error.

const kAlarmRemedies = {
  1: 'Move the axis off the switch by hand first.',
  2: 'Unlock, and move the job or its origin so that it fits.',
  3: 'Without switches: unlock, and set the origin again.',
  4: 'Unlock; free the probe, or move away from the plate, and probe again.',
  5: 'Unlock; start nearer to the plate, or probe farther.',
  6: 'Home again.',
  7: 'Close the door and home again.',
  8: 'Check the limit switch, or raise the pull-off $27; home again.',
  9: 'Check the limit switch, or raise the travel $130…; home again.',
  10: 'Check the second switch of the axis; home again.',
  11: 'Home the machine.',
  23: 'Home again; send fewer tiny lines, or slower.',
  24: 'Release the emergency stop, then home.',
  25: 'Check the cable and the sender; unlock, and resume the job.',
  26: 'Unlock, and mend the line that is named.',
  27: 'Unlock, and begin the job anew or from a line.',
};
const kErrorRemedies = {
  8: 'Wait until the machine is idle.',
  9: 'Home or unlock first.',
  13: 'Close the door.',
  15: 'Jog less far, or home again.',
  20: 'Leave the word out, or have the program written for Grbl.',
  22: 'Set a feed with F.',
  33: 'Check the target: it is out of reach.',
  79: 'Release the emergency stop.',
};

// `text` is the controller's own sentence about it.
export function alarmWords(number, text) {
  return `Alarm ${number}: ${text} ${kAlarmRemedies[number] ?? ''}`.trim();
}

// An answer of the controller, with the remedy where there is one to tell.
export function answerWords(line) {
  const number = /^error:(\d+)/.exec(line)?.[1];
  return kErrorRemedies[number] ? `${line}  (${kErrorRemedies[number]})` : line;
}
