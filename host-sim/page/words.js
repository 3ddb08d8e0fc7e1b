// Numbers of errors in words with a remedy. The server has the one table, of alarms, too.

let words = { errors: {} };

export async function loadWords() { words = await (await fetch('words')).json(); }

// An answer of the controller, with words where it is an error.
export function answerWords(line) {
  const number = /^error:(\d+)/.exec(line)?.[1];
  return words.errors[number] ? `${line}  (${words.errors[number]})` : line;
}
