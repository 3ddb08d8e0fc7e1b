// Starts Debian's Chromium, driven by playwright-core.

import fs from 'node:fs';
import path from 'node:path';

import { load, repository } from './support.mjs';

const kPictures = process.env.SCREENSHOTS ?? path.join(repository, 'build/screenshots');

export function openBrowser() {
  const executablePath = ['/usr/bin/chromium', '/usr/bin/google-chrome'].find(fs.existsSync);
  // No sandbox: tests run as root in containers; only pages of this machine are opened.
  return load('playwright-core').chromium.launch({ executablePath, args: ['--no-sandbox'] });
}

/// Saves a picture of the page in the build folder, for a visual check.
export async function screenshot(page, name) {
  fs.mkdirSync(kPictures, { recursive: true });
  await page.screenshot({ path: path.join(kPictures, name) });
}
