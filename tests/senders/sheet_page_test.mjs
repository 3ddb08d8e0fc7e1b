// Tests the page on which a sheet is laid out. Drawings are added, moved by number, key and mouse,
// rotated and copied. Faults are reported. A saved sheet is cut as shown, and can be opened again.
// The test runs at two sizes of the window.

import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

import { openBrowser, screenshot } from './browser.mjs';
import { check, equal, example, run, serve, until } from './support.mjs';

const kWide = { width: 1366, height: 768 };
const kNarrow = { width: 390, height: 844 };
const kSquare = '<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="20mm" viewBox="0 0 20 20">'
  + '<rect x="0" y="0" width="20" height="20"/></svg>';

const text = (page, id) => page.locator(`#${id}`).innerText();
const copies = (page) => page.locator('#sheet .copy').count();
const faults = (page) => page.locator('#faults li').allInnerTexts();

// Waits until the server has placed the shown drawings.
const settled = (page) => until('the server', async () => (await page.locator('#sheet').getAttribute('aria-busy')) === 'false');

async function set(page, id, value) {
  await page.locator(`#${id}`).fill(String(value));
  await page.locator(`#${id}`).press('Enter');
}

async function saved(page, folder) {
  const download = page.waitForEvent('download');
  await page.locator('#save').click();
  const file = path.join(folder, 'sheet.json');
  await (await download).saveAs(file);
  return file;
}

async function laysOut(page, folder) {
  fs.writeFileSync(path.join(folder, 'square.svg'), kSquare);
  fs.copyFileSync(example('plate.svg'), path.join(folder, 'plate.svg'));
  check(await page.locator('#x').isDisabled(), 'nothing is chosen yet');
  await page.locator('#drawing-files').setInputFiles([path.join(folder, 'plate.svg'), path.join(folder, 'square.svg')]);
  await until('both parts', async () => (await copies(page)) === 2);
  await until('they overlap', async () => (await faults(page)).some((fault) => /overlap/.test(fault)));
  await set(page, 'x', 200);
  await until('they do not any more', async () => (await faults(page)).length === 0);
  await page.locator('#another').click();
  await until('three copies', async () => (await copies(page)) === 3);
  equal(await page.locator('#x').inputValue(), '225', 'it lies beside the other one');
  await page.locator('#sheet').focus();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('r');
  await until('all keys', async () => (await page.locator('#angle').inputValue()) === '90');
  equal(await page.locator('#x').inputValue(), '235', 'moved to the right');
  equal(await page.locator('#y').inputValue(), '6', 'moved up');
}

async function drags(page) {
  await settled(page);
  const box = await until('the chosen copy', () => page.locator('#sheet .copy.chosen').boundingBox());
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y - 40, { steps: 4 });
  await page.mouse.up();
  await until('it was moved', async () => Number(await page.locator('#x').inputValue()) > 245);
  await settled(page);
  const moved = await until('it is there', () => page.locator('#sheet .copy.chosen').boundingBox());
  check(Math.abs(moved.x - box.x - 60) < 2 && Math.abs(moved.y - box.y + 40) < 2, 'as far as the mouse');
  await set(page, 'x', 270);
  await set(page, 'y', 150);
}

async function isCutAsShown(page, folder) {
  await settled(page);
  const file = await saved(page, folder);
  const sheet = JSON.parse(fs.readFileSync(file, 'utf8'));
  equal(sheet.parts.map((part) => part.drawing), ['plate.svg', 'square.svg'], 'the drawings');
  equal(sheet.parts[1].places, [{ x_mm: 200, y_mm: 5 }, { x_mm: 270, y_mm: 150, angle_deg: 90 }], 'the places');
  const report = path.join(folder, 'report.json');
  execFileSync(process.env.KERFLINE, ['cut', file, '--material', 'CSP 1N', '--thickness', '2',
    '-o', path.join(folder, 'out.nc'), '--report', report]);
  equal(JSON.parse(fs.readFileSync(report, 'utf8')).faults, [], 'it is cut');
  return file;
}

async function opensAgain(page, folder, file) {
  await page.reload();
  await page.locator('#sheet-file').setInputFiles(file);
  await until('what is missing is told', async () => (await faults(page)).some((fault) => /plate\.svg is not here/.test(fault)));
  check((await text(page, 'parts')).includes('its drawing is missing'), 'in the list, too');
  await page.locator('#drawing-files').setInputFiles([path.join(folder, 'plate.svg'), path.join(folder, 'square.svg')]);
  await until('all copies', async () => (await copies(page)) === 3);
  await until('no faults', async () => (await faults(page)).length === 0);
  await screenshot(page, 'sheet-1366.png');
  await page.setViewportSize(kNarrow);
  await screenshot(page, 'sheet-390.png');
  await page.setViewportSize(kWide);
}

async function refusesWhatIsNoSheet(page, folder) {
  const file = path.join(folder, 'bad.json');
  for (const [content, message] of [['{', /is not opened/], ['{"a":1}', /is not opened/],
    ['{"kerfline_sheet":1,"stock":{"width_mm":10,"height_mm":10},"parts":[{"drawing":"a.svg","copies":-3}]}', /\/parts\/0\/copies/]]) {
    fs.writeFileSync(file, content);
    await page.locator('#sheet-file').setInputFiles(file);
    await until('it is refused', async () => message.test(await text(page, 'notice')));
    equal(await copies(page), 3, 'the sheet before is still here');
    await page.locator('#notice button').click();
  }
  await page.locator('#remove').isDisabled();
}

await run('page of the sheet', async ({ folder, keep }) => {
  const server = keep(await serve(['--ws', '0']));
  const browser = await openBrowser();
  keep({ name: 'browser', output: '', stop: () => browser.close() });
  const page = await browser.newPage({ viewport: kWide });
  page.on('dialog', (dialog) => dialog.accept());
  page.setDefaultTimeout(90_000);
  await page.goto(`http://${server.ways.ws}/sheet.html`);
  await laysOut(page, folder);
  await drags(page);
  await opensAgain(page, folder, await isCutAsShown(page, folder));
  await refusesWhatIsNoSheet(page, folder);
});
