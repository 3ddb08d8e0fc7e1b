// Connects the parts of the page: passes news of the server to the displays, and actions of the
// controls to the sender and the job.

import { Job } from './job.js';
import { listenToKeys } from './keys.js';
import { Log } from './log.js';
import { Notice } from './notice.js';
import { Observer } from './observer.js';
import { leavesBehind, reasons } from './permission.js';
import { ask } from './question.js';
import { Sender } from './sender.js';
import { show } from './display.js';
import { View } from './view.js';
import { loadWords } from './words.js';

const kRealtime = { reset: 0x18, hold: 0x21, resume: 0x7E, jogCancel: 0x85 };
const kFeed = { all: 0x90, plus10: 0x91, minus10: 0x92, plus1: 0x93, minus1: 0x94 };
const kPower = { all: 0x99, plus10: 0x9A, minus10: 0x9B, plus1: 0x9C, minus1: 0x9D };
const kRapid = { 100: 0x95, 50: 0x96, 25: 0x97 };
const kTryAgainLater = 1013;
// Key in the session storage of the tab. It makes a reloaded page take control again if it had
// control.
const kHadControl = 'control';

const at = (id) => document.getElementById(id);
const sender = new Sender();
const observer = new Observer();
const view = new View(at('view'));
const job = new Job();
const log = new Log(at('log'));
const notice = new Notice(at('notice'));
let news = null;
let controls = false;

function enable() {
  const why = reasons(news, controls, job.opening);
  for (const element of document.querySelectorAll('[data-control]')) {
    const reason = why[element.dataset.control];
    element.disabled = reason !== '';
    element.title = reason === '' ? '' : `Not now: ${reason}`;
  }
  at('open').classList.toggle('disabled', why.open !== '');
  at('open').title = why.open;
  at('take-up').hidden = news?.job.state !== 'stopped';
  at('why').textContent = why.run === '' ? '' : `Run waits for ${why.run}.`;
  at('control').setAttribute('aria-pressed', String(controls));
  at('control').firstChild.data = controls ? 'Give up control ' : 'Take control ';
}

function command(line) { sender.send(line).catch(() => {}); }

function jog(words) {
  const axis = words[0];
  const step = Number(words.slice(1)) * Number(at('jog-step').value);
  command(`$J=G91 G21 ${axis}${step} F${Number(at('jog-feed').value) || 1000}`);
}

// Changes an override from `from` to `to`, in %. Realtime bytes change it in steps of 10 and 1.
function override(codes, from, to) {
  let rest = to - from;
  for (; rest >= 10; rest -= 10) sender.realtime(codes.plus10);
  for (; rest <= -10; rest += 10) sender.realtime(codes.minus10);
  for (; rest > 0; --rest) sender.realtime(codes.plus1);
  for (; rest < 0; ++rest) sender.realtime(codes.minus1);
}

function slide(id, index, codes) {
  at(id).addEventListener('change', () => override(codes, news.overrides[index], Number(at(id).value)));
}

// Shows the first fault of the program. Without faults, shows its first note: on stale inputs, or
// on parts of the file that were left out.
function tellFaults({ faults, count, notes }) {
  const first = faults[0] ?? notes[0];
  if (!first) return;
  const rest = (faults.length > 0 ? count : notes.length) - 1;
  const more = rest > 0 ? ` (and ${rest} more)` : '';
  notice.tell(`${job.name}, ${first}${more}`, (now) => now.job.state === 'running' || now.job.id !== job.id);
}

function tellWhatItWaitsFor({ waits }) {
  if (waits) notice.tell(`The job waits for ${waits}.`, (now) => now.job.state === 'running');
}

// Runs the job. If the controller would refuse lines of the job, or if the job leaves the travel,
// the operator must first accept the list of these faults.
async function run() {
  notice.clear();
  let answer = await job.run(sender.page, []);
  if (answer.faults) {
    const count = answer.fault_count;
    const yes = await ask(`${job.name} has ${count} fault${count > 1 ? 's' : ''}. The job stops at a line that is refused.`,
      answer.faults, 'Run nevertheless');
    if (!yes) return;
    answer = await job.run(sender.page, answer.faults);
  }
  tellWhatItWaitsFor(answer);
}

async function takeUp() {
  notice.clear();
  const yes = await ask(`Resume ${news.job.name} at line ${news.job.line}?`,
    ['The machine moves with the beam off to the position where the beam went off, and cuts on from there.'], 'Resume');
  if (yes) tellWhatItWaitsFor(await job.resume(sender.page));
}

async function showProgram(load) {
  const found = await load().catch((reason) => ({ faults: [reason.message], count: 1, notes: [] }));
  view.job = job.points;
  view.fit();
  tellFaults(found);
  return found;
}

async function open(file) {
  if (reasons(news, controls, job.opening).open) return;
  notice.clear();
  const shown = showProgram(() => job.open(file));
  enable();
  await shown;
  enable();
}

// Shows the program that another page has opened, in place of the program shown so far.
async function showOther() {
  const shown = job.name;
  const { faults } = await showProgram(() => job.restore());
  if (shown !== '' && faults.length === 0) {
    notice.tell(`Another page has opened ${job.name}.`, (now) => now.job.state === 'running');
  }
}

// Reacts to differences of the job and the alarm between the present news and the news `before`.
function follow(before) {
  if (news.job.state !== 'none' && news.job.id !== job.id && before?.job.id !== news.job.id && !job.opening) {
    showOther();
  }
  if (news.job.state === 'stopped' && before?.job.state !== 'stopped' && news.job.trouble !== '') {
    notice.tell(`${news.job.name} stopped: ${news.job.trouble}`, (now) => now.job.state !== 'stopped');
  }
  const alarm = news.state === 'Alarm' && news.alarm > 0 ? `Alarm ${news.alarm}: ${news.alarm_text}` : '';
  if (at('alarm').textContent !== alarm) at('alarm').textContent = alarm;
  at('alarm').hidden = alarm === '';
}

observer.addEventListener('news', (event) => {
  const before = news;
  news = view.news = event.detail;
  view.path = observer.path;
  notice.attend(news);
  follow(before);
  show(news, view, controls);
  view.draw();
  enable();
});
observer.addEventListener('refused', (event) => notice.tell(event.detail, () => true));
observer.addEventListener('lost', () => {
  news = null;
  at('state').textContent = 'Lost';
  at('state').dataset.state = 'Lost';
  enable();
});

// `ready` also comes after a reset. The notice with the reason why a job stopped must stay then.
sender.addEventListener('ready', () => {
  if (!controls) notice.clear();
  controls = true;
  sessionStorage.setItem(kHadControl, 'yes');
  if (news?.job.state !== 'running') sender.send('$I', true).catch(() => {});
  enable();
});
sender.addEventListener('line', (event) => log.answer(event.detail));
sender.addEventListener('sent', (event) => log.sent(event.detail));
sender.addEventListener('closed', (event) => {
  controls = false;
  if (event.detail === kTryAgainLater) {
    notice.tell('Another sender controls the machine. You can watch; take control when that sender has disconnected.',
      (now) => now.sender === '' || now.sender === 'job');
  }
  enable();
});

at('control').onclick = () => {
  sessionStorage.removeItem(kHadControl);
  if (sender.connected) sender.disconnect(); else sender.connect();
};
at('file').onchange = async () => {
  const file = at('file').files[0];
  // Without this, choosing the same file again after a change would cause no event.
  at('file').value = '';
  if (file) await open(file);
};
at('run').onclick = run;
at('take-up').onclick = takeUp;
at('stop').onclick = async () => tellWhatItWaitsFor(await job.stop(sender.page));
at('hold').onclick = () => { if (controls) sender.realtime(kRealtime.hold); else fetch('hold', { method: 'POST' }); };
at('resume').onclick = () => sender.realtime(kRealtime.resume);
at('reset').onclick = () => sender.realtime(kRealtime.reset);
at('jog-cancel').onclick = () => sender.realtime(kRealtime.jogCancel);
at('home').onclick = () => command('$H');
at('unlock').onclick = () => command('$X');
at('zero').onclick = () => command('G10 L20 P0 X0 Y0 Z0');
at('shortcuts-button').onclick = () => at('shortcuts').showModal();
at('send').onsubmit = (event) => {
  event.preventDefault();
  if (reasons(news, controls, job.opening).console) return;
  if (at('line').value.trim() !== '') command(at('line').value.trim());
  at('line').value = '';
};
slide('feed-override', 0, kFeed);
slide('power-override', 2, kPower);
for (const button of document.querySelectorAll('[data-rapid]')) {
  button.onclick = () => sender.realtime(kRapid[button.dataset.rapid]);
}
for (const button of document.querySelectorAll('[data-jog]')) button.onclick = () => jog(button.dataset.jog);

// Warns an operator who closes the page while a job runs or the machine is not idle, because the
// machine continues without the page.
addEventListener('beforeunload', (event) => {
  if (!leavesBehind(news, controls)) return;
  event.preventDefault();
  event.returnValue = '';
});

listenToKeys({
  o: () => { if (!reasons(news, controls, job.opening).open) at('file').click(); },
  '/': () => at('line').focus(),
  '[': () => controls && sender.realtime(kFeed.minus10),
  ']': () => controls && sender.realtime(kFeed.plus10),
  f: () => view.fit(),
  '+': () => view.zoom(1.25),
  '-': () => view.zoom(0.8),
});
enable();
loadWords().catch(() => {});
if (sessionStorage.getItem(kHadControl)) sender.connect();
