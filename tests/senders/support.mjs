// Functions for all sender tests: the simulated controller as a process, a separate folder for
// files, waiting with a reason, and a verdict.
//
// KERFLINE names the program, SENDERS the folder with node_modules (npm ci of the package-lock.json
// in this folder).

import { spawn } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const repository = fileURLToPath(new URL('../../', import.meta.url));
const program = process.env.KERFLINE ?? path.join(repository, 'build/release/host-sim/kerfline');
const senders = process.env.SENDERS ?? path.join(repository, 'build/senders');

/// Loads a package that the lock file pins.
export const load = createRequire(path.join(senders, 'package.json'));
export const inSenders = (...parts) => path.join(senders, ...parts);
export const example = (name) => path.join(repository, 'host-sim/examples', name);

export const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/// Resolves with the first truthy value of `probe`; fails with the text `what` after `ms`.
export async function until(what, probe, ms = 10_000) {
  const end = Date.now() + ms;
  for (;;) {
    const value = await probe();
    if (value) return value;
    if (Date.now() > end) throw new Error(`waited ${ms} ms in vain: ${what}`);
    await sleep(20);
  }
}

export function check(holds, what) {
  if (!holds) throw new Error(`does not hold: ${what}`);
}

export function equal(actual, expected, what) {
  const [a, e] = [JSON.stringify(actual), JSON.stringify(expected)];
  if (a !== e) throw new Error(`${what}: ${a} instead of ${e}`);
}

/// A child process that always ends with the test. `output` grows while it runs.
export class Child {
  constructor(command, args, options = {}) {
    this.name = path.basename(command);
    this.output = '';
    this.process = spawn(command, args, { stdio: ['ignore', 'pipe', 'pipe'], ...options });
    for (const stream of [this.process.stdout, this.process.stderr]) {
      stream.on('data', (data) => (this.output += data));
    }
    this.exited = new Promise((resolve) => this.process.on('exit', resolve));
    this.process.on('error', (error) => (this.output += `\n${error}`));
  }

  async stop() {
    if (this.process.exitCode === null) this.process.kill('SIGTERM');
    const gone = await Promise.race([this.exited.then(() => true), sleep(3000)]);
    if (!gone) this.process.kill('SIGKILL');
  }
}

/// Starts `kerfline serve` with these arguments, and waits until it is ready. `ways.pty`,
/// `ways.tcp` … are its addresses.
export async function serve(args) {
  const child = new Child(program, ['serve', ...args]);
  await until('kerfline serve is ready', () => /^ready$/m.test(child.output)).catch((error) => {
    throw new Error(`${error.message}\n${child.output}`);
  });
  const lines = child.output.split('\n').map((line) => line.trim().split(' '));
  child.ways = Object.fromEntries(lines.filter((words) => words.length === 2));
  return child;
}

/// Runs a test with a new folder and a list of things to stop at the end.
export async function run(name, test) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'kerfline-'));
  const children = [];
  let status = 0;
  try {
    await test({ folder, keep: (child) => (children.push(child), child) });
    console.log(`${name}: passed`);
  } catch (error) {
    console.error(`${name}: FAILED\n${error.stack}`);
    for (const child of children) {
      if (child.output) console.error(`---- ${child.name}\n${child.output.slice(-4000)}`);
    }
    status = 1;
  }
  for (const child of children.reverse()) await child.stop();
  fs.rmSync(folder, { recursive: true, force: true });
  process.exit(status);
}
