// Wires the page: what is observed to the displays, the controls to the sender.

import { Job } from './job.js';
import { listenToKeys } from './keys.js';
import { Log } from './log.js';
import { Observer } from './observer.js';
import { Sender } from './sender.js';
import { show } from './display.js';
import { View } from './view.js';

const kRealtime = { reset: 0x18, hold: 0x21, resume: 0x7E, jogCancel: 0x85 };
const kFeed = { all: 0x90, plus10: 0x91, minus10: 0x92, plus1: 0x93, minus1: 0x94 };
const kPower = { all: 0x99, plus10: 0x9A, minus10: 0x9B, plus1: 0x9C, minus1: 0x9D };
const kRapid = { 100: 0x95, 50: 0x96, 25: 0x97 };
const kTryAgainLater = 1013;

const at = (id) => document.getElementById(id);
const sender = new Sender();
const observer = new Observer();
const view = new View(at('view'));
const job = new Job();
const log = new Log(at('log'));
let news = null;
let controls = false;

function notice(text) {
  at('notice').textContent = text;
  at('notice').hidden = text === '';
}

function enable() {
  for (const element of document.querySelectorAll('[data-control]')) element.disabled = !controls;
  const moving = ['Run', 'Jog', 'Home'].includes(news?.state);
  at('run').disabled = !controls || job.text === '' || job.running || moving;
  at('hold').disabled = !controls || !moving;
  at('resume').disabled = !controls || !['Hold', 'Door', 'Tool'].includes(news?.state);
  at('control').setAttribute('aria-pressed', String(controls));
  at('control').firstChild.data = controls ? 'Give up control ' : 'Take control ';
}

function command(line) { sender.send(line).catch(() => {}); }

function jog(words) {
  const axis = words[0];
  const step = Number(words.slice(1)) * Number(at('jog-step').value);
  command(`$J=G91 G21 ${axis}${step} F${Number(at('jog-feed').value) || 1000}`);
}

// The override moves in steps of ten and one.
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

async function run() {
  notice('');
  const fault = await job.run(sender);
  if (fault) notice(fault);
}

// Of another job meanwhile, nobody wants to know any more.
async function outline() {
  const text = job.text;
  const { points, fault } = await job.outline()
    .catch((reason) => ({ points: [], fault: `${job.name} is not drawn: ${reason.message}` }));
  if (job.text !== text) return;
  if (fault) notice(fault);
  view.job = points;
  view.fit();
}

observer.addEventListener('news', (event) => {
  news = view.news = event.detail;
  view.path = observer.path;
  show(news, view, controls);
  view.draw();
  enable();
});
observer.addEventListener('lost', () => {
  at('state').textContent = 'Lost';
  at('state').dataset.state = 'Lost';
});

sender.addEventListener('ready', () => {
  controls = true;
  notice('');
  sender.send('$I', true).catch(() => {});
  enable();
});
sender.addEventListener('line', (event) => log.answer(event.detail));
sender.addEventListener('sent', (event) => log.sent(event.detail));
sender.addEventListener('closed', (event) => {
  controls = false;
  if (event.detail === kTryAgainLater) {
    notice('Another sender controls the machine. You can watch; take control when it is gone.');
  }
  enable();
});

job.addEventListener('change', () => {
  at('job-name').textContent = job.count === 0 ? job.name : `${job.name}  ${job.done}/${job.count}`;
  at('progress').value = job.count === 0 ? 0 : job.done / job.count;
  enable();
});

at('control').onclick = () => (sender.connected ? sender.disconnect() : sender.connect());
at('file').onchange = async () => {
  const file = at('file').files[0];
  if (!file) return;
  at('file').value = ''; // The same file, changed meanwhile, may be chosen again.
  notice('');
  await job.open(file);
  await outline();
};
at('run').onclick = run;
at('hold').onclick = () => sender.realtime(kRealtime.hold);
at('resume').onclick = () => sender.realtime(kRealtime.resume);
at('reset').onclick = () => sender.realtime(kRealtime.reset);
at('jog-cancel').onclick = () => sender.realtime(kRealtime.jogCancel);
at('home').onclick = () => command('$H');
at('unlock').onclick = () => command('$X');
at('zero').onclick = () => command('G10 L20 P0 X0 Y0 Z0');
at('shortcuts-button').onclick = () => at('shortcuts').showModal();
at('send').onsubmit = (event) => {
  event.preventDefault();
  if (at('line').value.trim() !== '') command(at('line').value.trim());
  at('line').value = '';
};
slide('feed-override', 0, kFeed);
slide('power-override', 2, kPower);
for (const button of document.querySelectorAll('[data-rapid]')) {
  button.onclick = () => sender.realtime(kRapid[button.dataset.rapid]);
}
for (const button of document.querySelectorAll('[data-jog]')) button.onclick = () => jog(button.dataset.jog);

listenToKeys({
  o: () => at('file').click(),
  ' ': () => (at('resume').disabled ? at('hold') : at('resume')).click(),
  '/': () => at('line').focus(),
  '[': () => controls && sender.realtime(kFeed.minus10),
  ']': () => controls && sender.realtime(kFeed.plus10),
  f: () => view.fit(),
  '+': () => view.zoom(1.25),
  '-': () => view.zoom(0.8),
});
enable();
