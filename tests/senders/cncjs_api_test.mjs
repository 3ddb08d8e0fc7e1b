// Tests CNCjs over its socket API: it connects through a pty, streams an example with pauses,
// overrides, jogs, cancels, probes and resets.

import fs from 'node:fs';
import path from 'node:path';

import { CncjsUser, checkNothingRefused, startCncjs } from './cncjs.mjs';
import { check, equal, example, run, serve, sleep, until } from './support.mjs';
import { linesReceived } from './record.mjs';

const kPauses = process.env.KERFLINE_TIER === 'prove' ? 20 : 6;
const kSettings = example('laser.settings');

/// A line as CNCjs sends it, without comments and blanks.
const stripped = (line) => line.replace(/\([^)]*\)|;.*/g, '').replace(/\s+/g, '');

async function streamWithPauses(user, text) {
  await user.load('bracket.nc', text);
  user.command('gcode:start');
  await user.state('Run');
  for (let pause = 0; pause < kPauses; ++pause) {
    await sleep(250);
    user.command('gcode:pause');
    await user.state('Hold');
    user.command('gcode:resume');
    await user.state('Run');
  }
  await until('the job ends', () => user.workflow === 'idle', 120_000);
  await user.state('Idle', 60_000);
  equal(user.sender.received, user.sender.total, 'lines answered');
}

async function override(user) {
  for (const [name, value, field] of [['feedOverride', 10, 0], ['rapidOverride', 50, 1], ['spindleOverride', -10, 2]]) {
    user.command(name, value);
    const wanted = [110, 50, 90][field];
    await until(`${name} is reported`, () => Number(user.status.ov?.[field]) === wanted);
  }
  for (const [name, value] of [['feedOverride', 0], ['rapidOverride', 100], ['spindleOverride', 0]]) {
    user.command(name, value);
  }
  await until('overrides are back', () => user.status.ov?.map(Number).join() === '100,100,100');
}

async function jogAndCancel(user) {
  const [before] = user.position();
  user.type('$J=G91 G21 X100 F600');
  await user.state('Jog');
  await sleep(400);
  user.command('jogCancel');
  await user.state('Idle');
  const way = user.position()[0] - before;
  check(way > 1 && way < 99, `the jog ended on its way, after ${way} mm`);
  user.type('$J=G90 G53 X0 F12000');
  await until('back at zero', () => user.status.activeState === 'Idle' && user.position()[0] === 0);
}

async function probe(user) {
  user.type('G38.2 Z-20 F300');
  await until('the probe is reported', () => user.read.some((line) => /^\[PRB:.*:1\]$/.test(line)), 15_000);
  await user.state('Idle');
  user.type('G0 G53 Z0');
  await until('up again', () => user.status.activeState === 'Idle' && user.position()[2] === 0);
}

await run('CNCjs over its socket API', async ({ folder, keep }) => {
  const pty = path.join(folder, 'ttyKerfline');
  const record = path.join(folder, 'conversation');
  const controller = keep(
    await serve(['--pty', pty, '--settings', kSettings, '--speed', '4', '--record', record]),
  );
  const cncjs = keep(await startCncjs(folder, pty));
  const user = await CncjsUser.connect(cncjs, pty);

  const text = `${fs.readFileSync(example('bracket.nc'), 'utf8').replace(/M30\s*$/, '')}G0 X11.23 Y45.67\nM30\n`;
  await streamWithPauses(user, text);
  checkNothingRefused(user);
  equal(user.position(), [11.231, 45.669, 0], 'final position, to the step');

  await override(user);
  await jogAndCancel(user);
  await probe(user);
  checkNothingRefused(user);

  user.command('reset');
  await sleep(500);
  await user.state('Idle');
  equal(user.position(), [0, 45.669, 0], 'position after a reset at rest');
  user.close();
  await controller.stop();

  // Between the lines CNCjs requests `$G`; at the end it waits with its own dwell.
  const sent = text.split('\n').map(stripped).filter(Boolean);
  const received = linesReceived(record).map(stripped);
  const job = received.slice(received.indexOf(sent[0])).filter((line) => !line.startsWith('$'));
  equal(job.slice(0, sent.length), sent, 'lines as they came');
});
