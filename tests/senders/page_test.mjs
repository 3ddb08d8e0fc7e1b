// Tests the page of `kerfline serve` in a browser: it takes control, shows the outline of a job,
// starts it, shows the moving tool, holds, resumes and resets; by mouse, then by keyboard. A second
// page and a wrong Host are refused. page_job_test.mjs tests which actions a job on the server
// permits.

import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';

import { openBrowser, screenshot } from './browser.mjs';
import { check, equal, example, run, serve, until } from './support.mjs';

/// The page as its user sees it.
class Page {
  constructor(page) {
    this.page = page;
  }

  static async open(browser, url, foreign = []) {
    const page = await browser.newPage({ viewport: { width: 1280, height: 860 } });
    page.on('request', (request) => {
      const to = new URL(request.url());
      if (to.host !== new URL(url).host && !/^(data|blob):$/.test(to.protocol)) foreign.push(to.href);
    });
    page.on('pageerror', (problem) => foreign.push(String(problem)));
    await page.goto(url);
    return new Page(page);
  }

  text(id) {
    return this.page.locator(`#${id}`).innerText();
  }

  state(word) {
    return until(`the page says ${word}`, async () => (await this.text('state')).includes(word), 20_000);
  }

  /// Returns X Y Z in machine coordinates.
  async place() {
    const rows = await this.page.locator('#places tr').allInnerTexts();
    return rows.map((row) => Number(row.split(/\s+/).filter(Boolean)[2]));
  }

  moved(from) {
    return until(`the tool moves from ${from}`, async () => String(await this.place()) !== String(from));
  }

  async openJob(file) {
    await this.page.locator('#file').setInputFiles(file);
    await until('the job is ready', () => this.page.locator('#run').isEnabled());
  }
}

async function outlineOfJob(page, folder) {
  const picture = () => page.page.locator('#view').evaluate((canvas) => canvas.toDataURL());
  const open = async (text) => {
    const job = path.join(folder, 'outline.nc');
    fs.writeFileSync(job, text);
    const reply = page.page.waitForResponse((response) => /\/job\?/.test(response.url()));
    await page.openJob(job);
    return (await reply).json();
  };
  const before = await picture();
  const { points } = await open('G0 X10\nG3 X10 I-10 F600\n');
  equal(points.slice(0, 6), [0, 0, 0, 10, 0, 0], 'the way to the circle');
  for (let i = 6; i < points.length; i += 3) {
    check(Math.abs(Math.hypot(points[i], points[i + 1]) - 10) < 0.02, 'a circle of 10 mm');
  }
  await until('the outline is drawn', async () => (await picture()) !== before);
  check(await page.page.locator('#notice').isHidden(), 'nothing to complain of');
  await open('G1 X5 F600\nG1 X6 Q\n');
  await until('the page says what is refused', async () => (await page.text('notice')).includes('outline.nc, line 2: Q has no number'));
}

// While a program is uploaded, the server still has the last one, which must not run.
async function runWaitsForTheProgram(page, job) {
  let arrive;
  const arrival = new Promise((resolve) => { arrive = resolve; });
  await page.page.route(/\/job\?/, async (route) => { await arrival; await route.continue(); });
  await page.page.locator('#file').setInputFiles(job);
  for (const id of ['run', 'file']) {
    check(await page.page.locator(`#${id}`).isDisabled(), `${id} waits`);
  }
  check(/Run waits for the program that is being opened/.test(await page.text('why')), await page.text('why'));
  arrive();
  await until('the job is ready', () => page.page.locator('#run').isEnabled());
  await page.page.unroute(/\/job\?/);
}

async function byMouse(page, job) {
  await page.openJob(job);
  const start = await page.place();
  await page.page.locator('#run').click();
  await page.state('Run');
  await page.moved(start);
  await page.page.locator('#hold').click();
  await page.state('Hold');
  await until('the beam is off', async () => (await page.text('power')) === '0');
  await screenshot(page.page, 'page-hold.png');
  await page.page.locator('#resume').click();
  await page.state('Run');
  await screenshot(page.page, 'page-run.png');
  await page.page.locator('#reset').click();
  await page.state('Alarm');  // The motion was cut off, so that the position is uncertain.
  await page.page.locator('#unlock').click();
  await page.state('Idle');
}

async function jobToTheEnd(page) {
  await page.openJob(example('circle_r20.nc'));
  await page.page.locator('#run').click();
  await page.state('Run');
  await until('the end of the job', () => page.page.locator('#progress').evaluate((bar) => bar.value === 1), 60_000);
  await page.state('Idle');
  check(await page.page.locator('#notice').isHidden(), `nothing to complain of: ${await page.text('notice')}`);
}

async function byKeyboard(page, job) {
  const press = (key) => page.page.keyboard.press(key);
  await page.page.locator('body').click({ position: { x: 5, y: 5 } });
  await page.openJob(job);
  await page.page.evaluate(() => document.activeElement?.blur());
  const start = await page.place();
  await press('Shift+R');
  await page.state('Run');
  await page.moved(start);
  await press('Space');
  await page.state('Hold');
  await press('Shift+Space');
  await page.state('Run');
  await press(']');
  await until('the override', async () => (await page.text('feed-percent')).startsWith('110'));
  await press('Shift+X');
  await page.state('Alarm');
  await press('Shift+U');
  await page.state('Idle');
  const [x] = await page.place();
  await press('Shift+ArrowRight');
  await until('a jog of ten', async () => Math.abs((await page.place())[0] - x - 10) < 0.002);
  await press('/');
  await page.page.keyboard.type('$G');
  await press('Enter');
  await until('the console shows the modes', async () => (await page.text('log')).includes('[GC:'));
}

async function secondPage(browser, url, first) {
  const second = await Page.open(browser, url);
  await second.state('Idle');  // The second page may watch,
  await second.page.locator('#control').click();
  await until('the reason why not',  // but not control the machine,
    async () => /Another sender/.test(await second.text('notice')));
  check(await second.page.locator('#hold').isDisabled(), 'a second page cannot hold');
  const [, y] = await second.place();
  await first.page.bringToFront();
  await first.page.keyboard.press('Escape');
  await first.page.locator('[data-jog="Y1"]').click();
  await until('it sees the first one jog', async () => Math.abs((await second.place())[1] - y - 10) < 0.002);
  await first.state('Idle');
  await first.page.locator('#control').click();  // until the first page gives up control.
  await until('nobody steers', async () => (await second.text('who')).startsWith('Not controlled'));
  await second.page.locator('#control').click();
  await until('control', async () => (await second.text('who')).startsWith('You'));
  await second.page.close();
}

function statusFor(address, headers) {
  const [host, port] = address.split(':');
  return new Promise((resolve, reject) =>
    http.get({ host, port, path: '/', headers }, (reply) => resolve(reply.statusCode)).on('error', reject),
  );
}

await run('the page of kerfline serve', async ({ folder, keep }) => {
  const settings = ['--settings', example('laser.settings'), '--set', '$20=0'];
  const controller = keep(await serve(['--ws', '0', ...settings]));
  const address = controller.ways.ws.replace(/^ws:\/\/|\/$/g, '');
  equal(await statusFor(address, {}), 200, 'the page');
  equal(await statusFor(address, { Host: 'kerfline.example' }), 403, 'the page for another host');

  const job = path.join(folder, 'job.nc');
  fs.copyFileSync(example('bracket.nc'), job);
  const browser = await openBrowser();
  keep({ stop: () => browser.close() });
  const foreign = [];
  const page = await Page.open(browser, `http://${address}/`, foreign);
  await page.page.locator('#control').click();
  await page.state('Idle');
  check(/^\d+\.\d+\.\d+/.test(await page.text('version')), 'the page shows the version');
  await outlineOfJob(page, folder);
  await runWaitsForTheProgram(page, job);
  await byMouse(page, job);
  await byKeyboard(page, job);
  await jobToTheEnd(page);
  await screenshot(page.page, 'page-idle.png');
  await secondPage(browser, `http://${address}/`, page);
  equal(foreign, [], 'requests to elsewhere, and faults of the page');
});
