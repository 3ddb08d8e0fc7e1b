// What may be done now, and why not: the one place where the page decides it.

const kMoving = ['Run', 'Jog', 'Home'];
const kOnlyRealtime = 'a job runs: only hold, resume, stop, reset and overrides act';

// Reasons why each kind of control is disabled; empty for one that is enabled.
export function reasons(news, controls) {
  const state = news?.state;
  const job = news?.job;
  const runs = job?.state === 'running';
  const base = !news ? 'the server is not there' : !controls ? 'take control first' : '';
  const lines = base || (runs ? kOnlyRealtime : '');
  const idle = lines || (state !== 'Idle' ? `the machine is in ${state}` : '');
  return {
    realtime: base,
    console: lines,
    zero: idle,
    jog: lines || (['Idle', 'Jog'].includes(state) ? '' : `the machine is in ${state}`),
    home: lines || (['Idle', 'Alarm'].includes(state) ? '' : `the machine is in ${state}`),
    unlock: lines || (state === 'Alarm' ? '' : 'there is no alarm'),
    hold: base || (kMoving.includes(state) ? '' : 'nothing moves'),
    resume: base || (['Hold', 'Door', 'Tool'].includes(state) ? '' : 'nothing is held'),
    stop: base || (runs ? '' : 'no job runs'),
    open: !news ? base : runs ? 'a job runs; another program is opened when it has ended' : '',
    run: runWaits(news, controls),
    takeUp: base || (job.state === 'stopped' ? (['Idle', 'Alarm'].includes(state) ? '' : `the machine is in ${state}`)
      : 'no job was interrupted'),
  };
}

function runWaits(news, controls) {
  if (!news) return 'the server';
  if (news.job.state === 'none') return 'a program: open one';
  if (news.job.state === 'running') return 'the end of the job that runs';
  if (!controls) return news.sender ? 'control, which another sender has' : 'control: take control';
  if (news.state === 'Alarm') return 'the end of the alarm: home or unlock';
  return news.state === 'Idle' ? '' : `an idle machine; it is in ${news.state}`;
}

// What a tab that is closed now would leave behind.
export function leavesBehind(news, controls) {
  if (!controls || !news) return false;
  return news.job.state === 'running' || news.state !== 'Idle';
}
