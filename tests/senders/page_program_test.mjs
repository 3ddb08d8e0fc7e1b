// Tests programs on the page of `kerfline serve`: the choice of the program that runs, skipped
// parts of a file, many faults, another page, another sender, and a stop during a tool change.

import fs from 'node:fs';
import net from 'node:net';
import path from 'node:path';

import { openBrowser, screenshot } from './browser.mjs';
import { check, equal, example, run, serve, sleep, until } from './support.mjs';

const kWide = { width: 1366, height: 768 };
const kNarrow = { width: 390, height: 844 };

const text = (page, id) => page.locator(`#${id}`).innerText();
const state = (page, word) => until(`the state ${word}`, async () => (await text(page, 'state')).includes(word), 60_000);
const workX = async (page) => Number((await page.locator('#places tr').first().innerText()).split(/\s+/)[1]);

async function open(browser, url) {
  const page = await browser.newPage({ viewport: kWide });
  page.setDefaultTimeout(90_000); // Other tests may use the processor, too.
  await page.goto(url);
  await until('news', async () => (await text(page, 'state')) !== '…');
  return page;
}

async function takeControl(page) {
  await page.locator('#control').click();
  await until('control', async () => (await text(page, 'who')).startsWith('You'));
}

async function openProgram(page, folder, name, content) {
  const file = path.join(folder, name);
  fs.writeFileSync(file, content);
  const reply = page.waitForResponse((response) => /\/job\?/.test(response.url()));
  await page.locator('#file').setInputFiles(file);
  const answer = await (await reply).json();
  await until('the page shows it', async () => (await text(page, 'job-name')).includes(name));
  return answer;
}

const done = (page) => until('the end of the job', async () => /, done$/.test(await text(page, 'job-name')), 60_000);

// The page treats text after M30, right and wrong checksums, a byte order mark and realtime bytes
// in a file as all tools of the program do.
async function readsFilesAsOtherToolsDo(page, folder) {
  await openProgram(page, folder, 'rest.nc', '\ufeffG91\nM110\nG1\u00a0X2 F6000 !\nM30\nG20\nG1 X5\n');
  await until('what was left out is told', async () => /rest\.nc, line 1: a byte order mark .*and \d more/.test(await text(page, 'notice')));
  const before = await workX(page);
  await page.locator('#run').click();
  await done(page);
  await until('it stands', async () => Math.abs((await workX(page)) - before - 2) < 0.002);
  await state(page, 'Idle');
  await openProgram(page, folder, 'wrong.nc', 'N1 G91*1\nG1 X5 F600\n');
  await until('no sender may begin with it', async () => /a program that can be sent; line 1: the check/.test(await text(page, 'why')));
  check(await page.locator('#run').isDisabled(), 'a wrong check is no matter of a question');
}

async function namesAllFaults(page, folder) {
  const name = 'faults.nc';
  const answer = await openProgram(page, folder, name, `${'G7\n'.repeat(135)}G0 X99999\n`);
  equal(answer.fault_count, 136, 'all are counted');
  await until('how many there are', async () => /faults\.nc, line 136: X needs .*\(and 135 more\)/.test(await text(page, 'notice')));
  await page.locator('#run').click();
  await until('the question', () => page.locator('#question').isVisible());
  const lines = await page.locator('#question-lines li').allInnerTexts();
  check(/has 136 faults/.test(await text(page, 'question-title')), 'how many');
  check(/^line 136: X needs \d{5}/.test(lines[0]), `the travel comes first: ${lines[0]}`);
  equal(lines.at(-1), 'and 35 more lines that are refused', 'the rest is counted');
  await screenshot(page, 'job-many-faults-1366.png');
  await page.setViewportSize(kNarrow);
  await screenshot(page, 'job-many-faults-390.png');
  const box = await page.locator('#question-yes').boundingBox();
  check(box.y + box.height <= kNarrow.height, 'the answers are on the screen');
  await page.setViewportSize(kWide);
  await page.locator('#question-no').click();
}

async function stopsInAToolChange(page, folder) {
  await openProgram(page, folder, 'tool.nc', 'G91 F6000\nM6 T1\nG20\nG91\nG1 X5\n');
  const before = await workX(page);
  await page.locator('#run').click();
  await state(page, 'Tool');
  const begun = Date.now();
  await page.locator('#stop').click();
  await until('it stopped', async () => /stopped: aborted/.test(await text(page, 'notice')));
  await state(page, 'Idle');
  check(Date.now() - begun < 9000, 'before a stop would give up');
  check(await page.locator('#resume').isDisabled(), 'nothing is held');
  await page.evaluate(() => document.activeElement?.blur());
  await page.keyboard.press('Shift+ ');
  await sleep(500);
  equal(await workX(page), before, 'and nothing goes on');
}

// Another page opens a program of the same name: the first page shows the new program, and runs
// what it shows.
async function secondTab(browser, url, page, folder) {
  await openProgram(page, folder, 'a.nc', 'G91 G1 X1 F6000\n');
  const other = await open(browser, url);
  await until('it shows the program', async () => (await text(other, 'job-name')).includes('a.nc'));
  check(/control, which another page has/.test(await text(other, 'why')), await text(other, 'why'));
  fs.mkdirSync(path.join(folder, 'other'));
  await openProgram(other, path.join(folder, 'other'), 'a.nc', 'G91 G1 X7 F6000\n');
  await until('the first page says so', async () => /Another page has opened a\.nc/.test(await text(page, 'notice')));
  const before = await workX(page);
  await page.locator('#run').click();
  await done(page);
  await until('what is shown is what runs', async () => Math.abs((await workX(page)) - before - 7) < 0.002);
  await other.locator('#control').click();
  await until('why not', async () => /Another sender/.test(await text(other, 'notice')));
  await other.close();
}

async function saysWhichSenderHasControl(page, address) {
  await page.locator('#control').click();
  await until('no control', async () => (await text(page, 'who')) === 'Not controlled');
  const [host, port] = address.split(':');
  const sender = net.connect({ host, port: Number(port) });
  await until('Controlled by', async () => (await text(page, 'who')) === 'Controlled by a sender over TCP');
  check(/control, which another sender has/.test(await text(page, 'why')), await text(page, 'why'));
  sender.destroy();
  await until('no control again', async () => (await text(page, 'who')) === 'Not controlled');
}

async function explainsErrorsInTheConsole(page) {
  await page.locator('#line').fill('G1 X1');
  await page.keyboard.press('Enter');
  await until('words', async () => /error:22  \(No feed is set\. Give a feed with F/.test(await text(page, 'log')));
}

await run('programs of the page', async ({ folder, keep }) => {
  const settings = ['--settings', example('laser.settings'), '--set', '$20=0'];
  const controller = keep(await serve(['--ws', '0', '--tcp', '0', ...settings]));
  const url = `http://${controller.ways.ws}/`;
  const browser = await openBrowser();
  keep({ stop: () => browser.close() });
  const page = await open(browser, url);
  await takeControl(page);
  await explainsErrorsInTheConsole(page);
  await readsFilesAsOtherToolsDo(page, folder);
  await namesAllFaults(page, folder);
  await stopsInAToolChange(page, folder);
  await secondTab(browser, url, page, folder);
  await saysWhichSenderHasControl(page, controller.ways.tcp);
});
