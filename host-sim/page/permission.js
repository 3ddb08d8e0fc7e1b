// Reasons for which controls are disabled. For what a job waits is decided by the server
// (run_conditions.hpp); this page knows only whether it has control itself.

const kHeldByHold = ['Run', 'Jog'];
const kOnlyRealtime = 'a job runs: only hold, resume, stop, reset and overrides act';

const kOpening = 'the program that is being opened';

// The reason for each kind of control; empty for one that is enabled. `opening` while a program is
// on its way to the server, which still has the one before.
export function reasons(news, controls, opening) {
  const state = news?.state;
  const job = news?.job;
  const runs = job?.state === 'running';
  const base = !news ? 'the server is not there' : !controls ? 'take control first' : '';
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
    // A feed hold is safe: every page may ask for it, with control or without.
    hold: !news ? base : kHeldByHold.includes(state) ? '' : 'nothing moves that a hold would stop',
    resume: base || (['Hold', 'Door', 'Tool'].includes(state) ? '' : 'nothing is held'),
    stop: base || (runs ? '' : 'no job runs'),
    open: !news ? base : opening ? kOpening : runs ? 'a job runs; another program is opened when it has ended' : '',
    run: !news ? 'the server' : opening ? kOpening : job.waits || waitsForControl(news, controls),
    takeUp: resumeWaits && `it waits for ${resumeWaits}`,
  };
}

function waitsForControl(news, controls) {
  if (controls) return '';
  return news.sender === 'page' ? 'control, which another page has' : 'control: take control';
}

// Whether a tab that is closed now would leave a job or a machine that moves behind.
export function leavesBehind(news, controls) {
  if (!controls || !news) return false;
  return news.job.state === 'running' || news.state !== 'Idle';
}
