// Reasons why controls of the page are disabled. The server determines the condition for which a
// job waits (run_conditions.hpp). The page itself only determines whether it has control.

const kHeldByHold = ['Run', 'Jog'];
const kOnlyRealtime = 'a job runs: only hold, resume, stop, reset and overrides act';

const kOpening = 'the program that is being opened';

// Returns, for each kind of control, the reason why it is disabled; an empty text if it is enabled.
// `opening` is true while a program is being sent to the server. Until that ends, the server still
// has the program before it.
export function reasons(news, controls, opening) {
  const state = news?.state;
  const job = news?.job;
  const runs = job?.state === 'running';
  const base = !news ? 'the server does not answer' : !controls ? 'take control first' : '';
  const lines = base || (runs ? kOnlyRealtime : '');
  const idle = lines || (state !== 'Idle' ? `the machine is in ${state}` : '');
  const resumeWaits = !news ? 'the server' : opening ? kOpening : job.resume_waits || waitsForControl(news, controls);
  return {
    realtime: base,
    console: lines,
    zero: idle,
    jog: lines || (['Idle', 'Jog'].includes(state) ? '' : `the machine is in ${state}`),
    home: lines || (['Idle', 'Alarm'].includes(state) ? '' : `the machine is in ${state}`),
    unlock: lines || (state === 'Alarm' ? '' : 'there is no alarm'),
    // A feed hold is safe, so every page may request it, with control or without.
    hold: !news ? base : kHeldByHold.includes(state) ? '' : 'the machine does not move',
    resume: base || (['Hold', 'Door', 'Tool'].includes(state) ? '' : 'nothing is held'),
    stop: base || (runs ? '' : 'no job runs'),
    open: !news ? base : opening ? kOpening : runs ? 'a job runs; open the program when it has ended' : '',
    run: !news ? 'the server' : opening ? kOpening : job.waits || waitsForControl(news, controls),
    takeUp: resumeWaits && `it waits for ${resumeWaits}`,
  };
}

function waitsForControl(news, controls) {
  if (controls) return '';
  return news.sender === 'page' ? 'control, which another page has' : 'control: take control';
}

// Returns whether closing the tab now would leave a running job or a machine that is not idle.
export function leavesBehind(news, controls) {
  if (!controls || !news) return false;
  return news.job.state === 'running' || news.state !== 'Idle';
}
