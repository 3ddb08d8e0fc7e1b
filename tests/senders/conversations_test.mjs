// Tests the lines that Candle, UGS, LaserGRBL and gSender send and the answers that they expect,
// over every transport. Usage: conversations_test.mjs pty|tcp|ws

import fs from 'node:fs';
import path from 'node:path';

import { check, equal, example, run, serve, sleep, until } from './support.mjs';
import { Talk } from './talk.mjs';

const kind = process.argv[2] ?? 'tcp';
const job = fs.readFileSync(example('circle_r20.nc'), 'utf8').split('\n').filter(Boolean);

/// Waits for the greeting, as all four senders do.
const greeting = (talk) => talk.seen(/^Grbl 1\.1[a-z] \['\$' for help\]$/);

/// Sends `byte` until the report shows the wanted override, as Candle does with its sliders.
async function untilOverride(talk, byte, wanted) {
  for (let sent = 0; sent < 20; ++sent) {
    talk.write(byte);
    await talk.status();
    if (talk.overrides === wanted) return;
  }
  throw new Error(`override ${wanted} is never reported: ${talk.overrides}`);
}

async function candle(talk) {
  const end = kind === 'pty' ? '\r' : '\n';
  await sleep(1000);
  talk.lines.length = 0;
  talk.write('\x18');
  await until('a line that begins with Grbl', () => talk.lines.some((line) => /^grbl/i.test(line)));
  await talk.accepted('$$', end);
  await talk.accepted('$#', end);
  await talk.accepted('S100', end);
  const words = (await talk.accepted('$G', end)).find((line) => line.startsWith('[GC:'));
  await untilOverride(talk, '\x91', '110,100,100');
  await untilOverride(talk, '\x90', '100,100,100');
  await talk.stream(job, 127, end);
  // Without the message before its acknowledgement, Candle would drop its queue.
  const last = talk.lines.lastIndexOf('ok');
  const before = talk.lines.slice(0, last).filter((line) => !line.startsWith('<'));
  equal(before.at(-1), '[MSG:Pgm End]', 'the line before the last acknowledgement');
  await talk.state('Idle');
  await talk.accepted(words.slice(4, -1), end);  // Candle restores the parser state that it stored.
}

async function ugs(talk) {
  await sleep(500);
  await talk.status();
  equal(await talk.ask(''), ['ok'], 'a blank line is answered');
  const identity = await talk.accepted('$I');
  check(identity.some((line) => /^\[VER:1\.1[a-z]\.\d+:.*\]$/.test(line)), 'a version');
  check(identity.some((line) => /^\[OPT:[A-Z0-9*+$#]*,\d+,\d+\]$/.test(line)), 'options');
  for (const line of await talk.accepted('$$')) check(/^\$\d+=-?[\d.]+$/.test(line), line);
  await talk.accepted('$G');
  await talk.stream(job, 128);
  await talk.state('Idle');
  await talk.accepted('$J=G21G91X20F1000');
  await talk.state('Jog');
  talk.write('\x85');
  await talk.state('Idle');
  const [x] = await talk.position();
  check(x < 40, `the jog was cancelled, at ${x}`);
  const probe = await talk.accepted('G38.2 Z-20 F400', '\n', 20_000);
  check(probe.some((line) => /^\[PRB:(-?\d*\.\d*,?)+:1\]$/.test(line)), `a probe result: ${probe}`);
}

async function laserGrbl(talk) {
  talk.write('\x18');
  await greeting(talk);
  const settings = await talk.accepted('$$');
  check(settings.includes('$32=1'), 'laser mode');
  const options = (await talk.accepted('$I')).find((line) => line.startsWith('[OPT:'));
  const room = Number(/,(\d+)\]$/.exec(options)[1]);
  equal(Number((await talk.status()).Bf?.split(',')[1]), room, 'free bytes while idle, as in [OPT:]');
  const raster = ['G21', 'G90', 'M4 S0', 'G0 X10 Y10'];
  for (let pixel = 0; pixel < 200; ++pixel) raster.push(`G1 X${(10 + 0.1 * pixel).toFixed(1)} S${(pixel * 37) % 1000} F6000`);
  await talk.stream([...raster, 'M5'], room);
  await talk.state('Idle');
  equal((await talk.position())[0], 29.9, 'end of the raster line');
  await talk.accepted('$J=G53X1Y1F6000');
  await talk.state('Idle');
  await untilOverride(talk, '\x9B', '100,100,90');
  await untilOverride(talk, '\x99', '100,100,100');
}

/// Patterns with which gSender and CNCjs read these lines.
const kEnumerations = {
  '$I+': /^\[(VER:1\.1[a-z]\.\d+:.*|OPT:[A-Z0-9*+$#]*,\d+,\d+|NEWOPT:[A-Z0-9,+-]*|AXS:\d+:[XYZABC]+|[A-Z ]+:[^\]]*)\]$/,
  $$: /^\$\d+=-?\d+(\.\d+)?$/,
  $G: /^\[GC:(?:[GMTFS]\d+(?:\.\d*)?\s?)+(?<! )\]$/,
  $ES: /^\[SETTING:(\d+)\|(\d+)\|([^|]+)\|([^|]*)\|(\d+)\|([^|]*)\|([^|]*)\|([^|]*)(\|[^\]]*)?\]$/,
  $ESH: /^(\[SETTINGDESCR:\d+\|.*\]|\d+\t.*)$/,
  $EG: /^\[SETTINGGROUP:(\d+)\|(\d+)\|([^\]]*)\]$/,
  $EA: /^\[ALARMCODE:(\d+)\|([^|]*)\|([^\]]*)\]$/,
  $EE: /^\[ERRORCODE:(\d+)\|([^|]*)\|([^\]]*)\]$/,
  '$#': /^\[(G5[4-9](\.[1-3])?|G28|G30|G92|PRB|TLO|HOME|TLR):.*\]$/,
};

async function gSender(talk) {
  await talk.accepted('$I');
  talk.write('\x87');
  await until('a full report', () => talk.report);
  for (const [command, pattern] of Object.entries(kEnumerations)) {
    const lines = await talk.accepted(command);
    check(lines.length > 0, `${command} lists something`);
    for (const line of lines) check(pattern.test(line), `${command}: ${line}`);
  }
  // gSender writes realtime bytes as UTF-8.
  talk.write('\xC2\x91');
  await until('feed override', async () => (await talk.status(), talk.overrides === '110,100,100'));
  talk.write('\xC2\x90');
  await until('feed override', async () => (await talk.status(), talk.overrides === '100,100,100'));
  await talk.accepted('$J=G91G21X30F600');
  await talk.state('Jog');
  talk.write('\xC2\x85');
  await talk.state('Idle');
  await talk.stream(job.map((line) => `${line} (Größe 3 × 5 ф)`), 100);
  await talk.state('Idle');
}

/// Polling intervals: each sender polls by a timer while it is connected; the controller relies on
/// it ($858).
const kPollMs = { candle: 75, ugs: 200, laserGrbl: 250, gSender: 250 };

const settings = ['--settings', example('laser.settings')];

await run(`conversations over ${kind}`, async ({ folder, keep }) => {
  const way = { pty: path.join(folder, 'tty'), tcp: '127.0.0.1:0', ws: '0' }[kind];
  const controller = keep(await serve([`--${kind}`, way, ...settings, '--speed', '4']));
  for (const sender of [candle, ugs, laserGrbl, gSender]) {
    const talk = await Talk.open(kind, controller.ways[kind]);
    await greeting(talk);
    talk.pollEvery(kPollMs[sender.name]);
    await sender(talk);
    talk.close();
    await sleep(700);
    console.log(`  ${sender.name}: ${talk.acks} acknowledgements, ${talk.lines.length} lines`);
  }
});
