// Tests the page of CNCjs in a browser: it chooses the port, opens it, loads a file, runs, pauses,
// resumes, and shows that the machine comes to rest.

import fs from 'node:fs';
import path from 'node:path';

import { openBrowser, screenshot } from './browser.mjs';
import { startCncjs } from './cncjs.mjs';
import { example, run, serve, until } from './support.mjs';

await run('CNCjs in a browser', async ({ folder, keep }) => {
  const pty = path.join(folder, 'ttyKerfline');
  keep(await serve(['--pty', pty, '--settings', example('laser.settings')]));
  const cncjs = keep(await startCncjs(folder, pty));
  const browser = await openBrowser();
  keep({ stop: () => browser.close() });
  const page = await browser.newPage({ viewport: { width: 1400, height: 1000 } });
  const foreign = [];
  page.on('request', (request) => {
    if (!request.url().startsWith(cncjs.url) && !/^(data|blob|ws):/.test(request.url())) foreign.push(request.url());
  });
  const shows = (text) =>
    until(`the page shows ${text}`, () => page.evaluate((word) => document.body.innerText.includes(word), text), 30_000);

  await page.goto(cncjs.url);
  await page.locator('.Select', { hasText: 'Choose a port' }).locator('.Select-arrow-zone').click();
  await page.locator('.Select-option', { hasText: pty }).first().click();
  await page.getByRole('button', { name: 'Open' }).first().click();
  await shows('Idle');

  const job = path.join(folder, 'job.nc');
  const lines = fs.readFileSync(example('bracket.nc'), 'utf8').split('\n').slice(0, 60);
  fs.writeFileSync(job, [...lines, 'G0 X10 Y20', 'M2', ''].join('\n'));
  await page.locator('input[type=file]').first().setInputFiles(job);
  await page.locator('button[title="Run"]:not([disabled])').first().click({ timeout: 20_000 });
  await shows('Run');
  await page.locator('button[title="Pause"]:not([disabled])').first().click();
  await shows('Hold');
  await screenshot(page, 'cncjs-hold.png');
  await page.locator('button[title="Resume"]:not([disabled])').first().click();
  await shows('Run');
  await shows('Idle');
  await shows('10.000');
  await shows('20.000');
  await screenshot(page, 'cncjs-done.png');
  if (foreign.length > 0) throw new Error(`requests to elsewhere: ${foreign.join(' ')}`);
});
