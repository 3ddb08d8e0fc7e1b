// Tests a job of the page of `kerfline serve`. While it runs, only realtime commands are enabled.
// The page asks before it runs a faulty program, an error stops the job, and the tab may be closed
// or reloaded.

import fs from 'node:fs';
import path from 'node:path';

import { openBrowser, screenshot } from './browser.mjs';
import { check, equal, example, run, serve, sleep, until } from './support.mjs';

const kWide = { width: 1366, height: 768 };
const kNarrow = { width: 390, height: 844 };

async function open(browser, url, viewport = kWide) {
  const page = await browser.newPage({ viewport });
  page.setDefaultTimeout(90_000); // Other tests may use the processor, too.
  await page.goto(url);
  return page;
}

const text = (page, id) => page.locator(`#${id}`).innerText();
const state = (page, word) => until(`the state ${word}`, async () => (await text(page, 'state')).includes(word), 60_000);
const enabled = (page, id) => page.locator(`#${id}`).isEnabled();

async function takeControl(page) {
  await page.locator('#control').click();
  await until('control', async () => (await text(page, 'who')).startsWith('You'));
}

async function openProgram(page, file) {
  const reply = page.waitForResponse((response) => /\/job\?/.test(response.url()));
  await page.locator('#file').setInputFiles(file);
  await reply;
}

const kOnlyAtRest = ['home', 'unlock', 'zero', 'line', 'file'];
const kRealtime = ['hold', 'reset', 'stop', 'feed-override', 'power-override', 'jog-cancel'];

async function onlyRealtimeWhileItRuns(page) {
  for (const id of kOnlyAtRest) check(!await enabled(page, id), `${id} is disabled while a job runs`);
  check(await page.locator('[data-jog]').first().isDisabled(), 'jog is disabled while a job runs');
  for (const id of kRealtime) check(await enabled(page, id), `${id} acts while a job runs`);
  check(/a job runs/.test(await page.locator('#zero').getAttribute('title')), 'zero says why not');
  check(/a job runs/.test(await page.locator('#line').getAttribute('title')), 'the console says why not');
  const before = await page.locator('#places tr').first().innerText();
  for (const key of ['z', 'Shift+Z', 'r', 'h', 'u', 'x', 'Shift+H', 'Shift+U', 'Shift+ArrowRight']) {
    await page.keyboard.press(key);
  }
  await sleep(300);
  await state(page, 'Run');
  const words = (await page.locator('#places tr').first().innerText()).split(/\s+/).map(Number);
  check(Math.abs(words[1] - words[2]) < 0.002, `no key moved the origin: ${before} ${words}`);
}

async function survivesReload(page) {
  const job = await text(page, 'job-name');
  let asked = 0;
  const accept = (dialog) => { ++asked; dialog.accept(); };
  page.on('dialog', accept);
  await page.reload();
  await until('the job again', async () => (await text(page, 'job-name')).startsWith(job.split(' ')[0]), 60_000);
  check(asked === 1, 'leaving the page is asked about');
  await until('control again', async () => (await text(page, 'who')).startsWith('You'), 60_000);
  await state(page, 'Run');
  check(await enabled(page, 'hold'), 'the job can be held from the page that came again');
  check(await page.locator('#run').isDisabled(), 'and not run twice');
  page.off('dialog', accept);
}

// The browser asks before the page is left, with the same event as before a tab is closed. If the
// user stays, the page is unchanged.
async function survivesClosing(browser, url, page) {
  await page.keyboard.press('f'); // Browsers ask only if the page has been used.
  const asked = [];
  page.on('dialog', (dialog) => {
    asked.push(dialog.type());
    dialog.dismiss();
  });
  await page.evaluate(() => { location.href = 'about:blank'; });
  await until('leaving the page is asked about', () => asked.length === 1);
  equal(asked, ['beforeunload'], 'by the browser');
  await sleep(300);
  await state(page, 'Run');
  check((await text(page, 'who')).startsWith('You'), 'the page stays, with control');
  await page.close({ runBeforeUnload: false });
  const other = await open(browser, url);
  await state(other, 'Run');
  check(/A job runs without an operator/.test(await text(other, 'who')), `no page controls it: ${await text(other, 'who')}`);
  await holdsWithoutControl(other);
  await takeControl(other);
  await other.locator('#hold').click();
  await state(other, 'Hold');
  await pictures(other, 'job-held');
  await other.locator('#resume').click();
  await state(other, 'Run');
  return other;
}

// Any page that sees the machine may hold the feed, which is safe. Shift is required only to give
// up control.
async function holdsWithoutControl(page) {
  await page.keyboard.press('c');
  await sleep(300);
  check(!(await text(page, 'who')).startsWith('You'), 'C alone does nothing');
  await page.keyboard.press(' ');
  await state(page, 'Hold');
  check(await page.locator('#resume').isDisabled(), 'but resuming takes control');
  await page.keyboard.press('Shift+C');
  await until('control', async () => (await text(page, 'who')).startsWith('You'));
  await page.locator('#resume').click();
  await state(page, 'Run');
  await page.keyboard.press('Shift+C');
  await until('control is given up', async () => !(await text(page, 'who')).startsWith('You'));
}

async function pictures(page, name) {
  await screenshot(page, `${name}-1366.png`);
  await page.setViewportSize(kNarrow);
  await sleep(100);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  check(wide <= kNarrow.width, `${name}: nothing is wider than the screen: ${wide}`);
  await screenshot(page, `${name}-390.png`);
  await page.setViewportSize(kWide);
}

async function stopAndResume(page) {
  await page.locator('#stop').click();
  await until('it stopped', async () => /stopped at line/.test(await text(page, 'job-name')), 20_000);
  await state(page, 'Idle');
  check(/aborted/.test(await text(page, 'notice')), `why: ${await text(page, 'notice')}`);
  await sleep(500);
  check(/aborted/.test(await text(page, 'notice')), 'the reason outlives the reset');
  await pictures(page, 'job-stopped');
  check(await enabled(page, 'take-up'), 'it can be resumed');
  await page.locator('#take-up').click();
  await page.locator('#question-yes').click();
  await state(page, 'Run');
  check(await page.locator('#notice').isHidden(), 'the banner has ended');
  await until('the beam', async () => (await text(page, 'power')) !== '0', 60_000);
  await page.locator('#reset').click();
  await state(page, 'Alarm');
  check(/Alarm 3: .*home again/i.test(await text(page, 'alarm')), `in words: ${await text(page, 'alarm')}`);
  await pictures(page, 'job-alarm');
  check(/Run waits for the end of the alarm/.test(await text(page, 'why')), await text(page, 'why'));
  await page.locator('#unlock').click();
  await state(page, 'Idle');
  check(await page.locator('#alarm').isHidden(), 'the alarm is told as long as it lasts');
}

async function asksAboutFaults(page, folder) {
  const file = path.join(folder, 'fault_and_beyond_travel.nc');
  fs.writeFileSync(file, 'G21 G90\nM4 S0\nG1 X10 F1000 S500\nG1 X20 Y999\nG7 X3\nM5\n');
  await openProgram(page, file);
  await until('the fault is told', async () => /line 4: Y needs/.test(await text(page, 'notice')));
  await page.locator('#run').click();
  const named = () => page.locator('#question-lines li').allInnerTexts();
  // Before this, the page still shows the lines of the last question.
  await until('both are named', async () => (await named()).length === 2);
  const lines = await named();
  check(/^line 4: Y needs \d/.test(lines[0]) && /^line 5: /.test(lines[1]), lines.join('; '));
  await pictures(page, 'job-question');
  await page.locator('#question-no').click();
  await sleep(200);
  await state(page, 'Idle');
}

async function stopsAtAnError(page, folder) {
  const file = path.join(folder, 'error.nc');
  fs.writeFileSync(file, `G91 G1 X1 F600 M4 S100\nG7\n${'G1 X1\n'.repeat(50)}`);
  await openProgram(page, file);
  await page.locator('#run').click();
  await page.locator('#question-yes').click();
  const words = /error.nc stopped: line 2: error:20: .*G7 is not supported\. Leave the word out/;
  await until('it stopped', async () => words.test(await text(page, 'notice')), 20_000);
  await state(page, 'Idle');
  const x = Number((await page.locator('#places tr').first().innerText()).split(/\s+/)[1]);
  await sleep(300);
  equal(Number((await page.locator('#places tr').first().innerText()).split(/\s+/)[1]), x, 'it stands');
}

async function narrow(browser, url) {
  const page = await open(browser, url, kNarrow);
  await until('the state', async () => (await text(page, 'state')) !== '…');
  await screenshot(page, 'page-390.png');
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  check(wide <= kNarrow.width, `nothing is wider than the screen: ${wide}`);
  await page.close();
}

await run('a job of the page', async ({ folder, keep }) => {
  const settings = ['--settings', example('laser.settings'), '--set', '$20=0', '--set', '$131=300'];
  const controller = keep(await serve(['--ws', '0', '--tcp', '0', ...settings]));
  const url = `http://${controller.ways.ws}/`;
  const browser = await openBrowser();
  keep({ stop: () => browser.close() });
  let page = await open(browser, url);
  await until('what Run waits for', async () => /Run waits for a program/.test(await text(page, 'why')));
  await screenshot(page, 'page-1366.png');
  const job = path.join(folder, 'bracket.nc');
  fs.copyFileSync(example('bracket.nc'), job);
  await openProgram(page, job);
  await until('control is wanted', async () => /Run waits for control/.test(await text(page, 'why')));
  await takeControl(page);
  await page.locator('#run').click();
  await state(page, 'Run');
  await screenshot(page, 'job-runs-1366.png');
  await onlyRealtimeWhileItRuns(page);
  await narrow(browser, url);
  await survivesReload(page);
  page = await survivesClosing(browser, url, page);
  await stopAndResume(page);
  await asksAboutFaults(page, folder);
  await stopsAtAnError(page, folder);
});
