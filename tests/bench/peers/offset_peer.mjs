// Compares our offset with the fastest open-source one, CavalierContours in Rust. Both run
// alternately in one process on the same contours, as WebAssembly in Node.js or both native.
// README.md lists the requirements.
//
// usage: node offset_peer.mjs [--native] [--pairs N] [--only CORPUS]

import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

const repository = fileURLToPath(new URL('../../../', import.meta.url));
const here = path.join(repository, 'build/peers');

const { values: asked } = parseArgs({
  options: {
    native: { type: 'boolean', default: false },
    pairs: { type: 'string', default: '7' },
    only: { type: 'string', default: '' },
  },
});

// Numbers of elements as in offset_speed.cpp.
const kCorpora = { nest: 400, mech: 400, glyphs: 400, spline: 400, star20: 400, star100: 400, star1000: 20 };
const kGears = [100, 1000, 10_000, 100_000];

// Long enough that the clock's resolution and the garbage collector do not matter.
const kBlockSeconds = 0.6;

const kPeerFile = 'node_modules/cavalier_contours_wasm/cavalier_contours_web_ffi_bg.wasm';
const kNames = ['DONT_VECTORIZE', 'NO_MALLOC', 'NO_DEBUG', 'MAX_STATIC_ALIGN_BYTES=0'];
const kFlags = [
  ...'-std=c++20 -ffp-contract=off -fno-math-errno -DKERFLINE_CONTRACT_TEXT=0'.split(' '),
  ...kNames.map((name) => `-DEIGEN_${name}`),
  ...'-I. -isystem /usr/include/eigen3'.split(' '),
];

function call(...words) {
  execFileSync(words[0], words.slice(1), { cwd: repository, stdio: 'inherit' });
}

/// Builds the planner's offset from the sources that the host's build uses for it.
function buildOurs() {
  const sources = ['offset', 'raw_offset', 'clean_outline', 'crowd_trim', 'cutting', 'wide_meeting'];
  sources.push('runs', 'run_selection', 'loop_writer', 'curve');
  const program = 'build/peers/our_offset.wasm';
  call(
    'clang++-14',
    ...'--target=wasm32-wasi -mexec-model=reactor -O3 -fno-exceptions -fno-rtti'.split(' '),
    ...kFlags,
    ...['add', 'vertices', 'offset', 'area', 'nothing'].map((name) => `-Wl,--export=our_${name}`),
    ...['-o', program, 'tests/bench/peers/our_offset.cpp', 'planner/geometry/wide_arc.cpp'],
    ...sources.map((name) => `planner/contour/${name}.cpp`),
  );
  return path.join(repository, program);
}

/// Ours is the library of the release build. wasm2c translates the peer to C. The C code guards the
/// bounds of its memory by pages that must not be read, which costs no time.
function buildNative() {
  const inBuild = (name) => `build/peers/${name}`;
  call('wasm2c', '-n', 'peer', inBuild(kPeerFile), '-o', inBuild('peer.c'));
  call('gcc', '-O3', '-c', inBuild('peer.c'), '-o', inBuild('peer.o'));
  call(
    'g++',
    '-O2',
    ...kFlags,
    ...['-Ibuild/peers', 'tests/bench/peers/our_offset.cpp', 'tests/bench/peers/native_pair.cpp'],
    ...[inBuild('peer.o'), 'build/release/planner/libkerfline_planner.a', '-lwasm-rt-impl', '-lm'],
    ...['-o', inBuild('native_pair')],
  );
  return path.join(here, 'native_pair');
}

/// Returns a function for an import that a program must not call while it offsets.
const refuse = (name) => () => {
  throw new Error(`called ${name}`);
};

/// Both classes offset the case of a given number, and return the area of the result.
class Ours {
  name = 'kerfline';

  constructor(bytes) {
    const module = new WebAssembly.Module(bytes);
    const imports = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      (imports[from] ??= {})[name] = refuse(name);
    }
    this.wasm = new WebAssembly.Instance(module, imports).exports;
    this.wasm._initialize();
  }

  add(vertices) {
    const number = this.wasm.our_add(vertices.length / 3);
    const first = this.wasm.our_vertices(number);
    new Float64Array(this.wasm.memory.buffer, first, vertices.length).set(vertices);
    return number;
  }

  offset(number, distance) {
    const loops = this.wasm.our_offset(number, distance);
    if (loops < 0) throw new Error(`no offset of case ${number} by ${distance}`);
    return loops;
  }

  area(number, distance) {
    this.offset(number, distance);
    return this.wasm.our_area();
  }

  nothing(number) {
    return this.wasm.our_nothing(number);
  }
}

/// The peer's index of boxes, tolerances and memory have their default values. Each result is freed
/// immediately, as a Rust program would do. The peer's own wrapper is made for bundlers and would
/// wrap every polyline in an object. This class contains only the functions that the offset calls,
/// and does less work.
class Peer {
  name = 'cavalier_contours';

  constructor(bytes) {
    const module = new WebAssembly.Module(bytes);
    const imports = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      (imports[from] ??= {})[name] = this.#provided(name) ?? refuse(name);
    }
    this.found = [];
    this.wasm = new WebAssembly.Instance(module, imports).exports;
  }

  /// The peer hands over each polyline by its address, to a list that it creates first.
  #provided(name) {
    if (name === '__wbg_polyline_new') return (address) => address;
    if (name.startsWith('__wbg_push_')) return (_, address) => this.found.push(address);
    if (name.startsWith('__wbg_new_')) return () => 0;
    if (name === '__wbindgen_object_drop_ref') return () => {};
    return undefined;
  }

  add(vertices) {
    const first = this.wasm.__wbindgen_malloc(vertices.length * 8);
    new Float64Array(this.wasm.memory.buffer, first, vertices.length).set(vertices);
    return this.wasm.polyline_new(first, vertices.length, true);
  }

  /// The peer's positive distance is to the left, ours to the right. Neither program, with its
  /// default options, handles loops of the input that cross themselves.
  #offset(polyline, distance) {
    this.found.length = 0;
    this.wasm.polyline_parallelOffset(polyline, -distance, false);
    return this.found;
  }

  offset(polyline, distance) {
    const found = this.#offset(polyline, distance);
    for (const each of found) this.wasm.__wbg_polyline_free(each);
    return found.length;
  }

  area(polyline, distance) {
    let area = 0;
    for (const each of this.#offset(polyline, distance)) {
      area += this.wasm.polyline_area(each);
      this.wasm.__wbg_polyline_free(each);
    }
    return area;
  }

  nothing(polyline) {
    return this.wasm.polyline_length(polyline);
  }
}

/// Removes elements of length zero, which the peer requires its callers to do.
function withoutRepeats(vertices) {
  return vertices.filter((_, i) => {
    const place = i - (i % 3);
    const next = (place + 3) % vertices.length;
    return vertices[place] !== vertices[next] || vertices[place + 1] !== vertices[next + 1];
  });
}

/// The peer offsets one loop at a time. Each loop of a contour therefore becomes a case.
function readCases(corpus, count) {
  const program = path.join(repository, 'build/release/tests/bench_offset_cases');
  const text = execFileSync(program, [corpus, String(count)], { maxBuffer: 1 << 28, encoding: 'latin1' });
  return text
    .trim()
    .split('\n')
    .flatMap((line) => {
      const [distance, loops, ...rest] = line.split(' ').map(Number);
      let place = loops;
      return rest.slice(0, loops).map((count) => {
        const vertices = rest.slice(place, place + 3 * count);
        place += 3 * count;
        return { distance, vertices: withoutRepeats(vertices) };
      });
    });
}

/// Returns small teeth around a circle, as `growth` in offset_speed.cpp does.
function gear(count) {
  const vertices = [];
  for (let i = 0; i < count; ++i) {
    const angle = (2 * Math.PI * i) / count;
    const size = count / 8 + (i % 2);
    vertices.push(size * Math.cos(angle), size * Math.sin(angle), 0.1);
  }
  return [{ distance: -0.4, vertices }];
}

const cpuSeconds = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) * 1e-6;
};

/// Returns the processor seconds of `rounds` rounds through all cases.
function seconds(program, cases, rounds) {
  const { numbers } = cases.get(program);
  const distances = cases.get('distances');
  const begun = cpuSeconds();
  for (let round = 0; round < rounds; ++round) {
    for (let i = 0; i < numbers.length; ++i) program.offset(numbers[i], distances[i]);
  }
  return cpuSeconds() - begun;
}

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];
const million = (value) => (value * 1e-6).toFixed(2).padStart(8);

/// Returns the number of cases whose two areas differ by more than 1e-6 of the area that the
/// distance sweeps.
function disagreements(programs, cases, list) {
  const areas = programs.map((program) =>
    cases.get(program).numbers.map((number, i) => program.area(number, list[i].distance)),
  );
  return list.filter(({ vertices, distance }, i) => {
    let swept = 0;
    for (let k = 0; k < vertices.length; k += 3) {
      const next = (k + 3) % vertices.length;
      swept += Math.hypot(vertices[next] - vertices[k], vertices[next + 1] - vertices[k + 1]);
    }
    const difference = Math.abs(areas[0][i] - areas[1][i]);
    return !(difference <= 1e-6 * swept * Math.abs(distance));
  }).length;
}

/// Returns the cases on which the peer does not panic. After a panic, the peer's memory is
/// unusable.
function withoutPanics(list, bytes) {
  let trial = new Peer(bytes);
  return list.filter(({ distance, vertices }) => {
    try {
      trial.offset(trial.add(vertices), distance);
      return true;
    } catch {
      trial = new Peer(bytes);
      return false;
    }
  });
}

function report(name, count, panics, { differ, ours, peer }) {
  const ratios = ours.map((rate, pair) => rate / peer[pair]);
  const spread = `${Math.min(...ratios).toFixed(2)}…${Math.max(...ratios).toFixed(2)}`;
  console.log(
    `${name.padEnd(12)}${million(median(ours))}${million(median(peer))}` +
      `${median(ratios).toFixed(2).padStart(8)}   ${spread.padEnd(13)}${String(count).padStart(6)}` +
      `${String(differ).padStart(8)}${String(panics).padStart(8)}`,
  );
}

function compareInNode(list, programs) {
  const cases = new Map([['distances', list.map(({ distance }) => distance)]]);
  for (const program of programs) {
    cases.set(program, { numbers: list.map(({ vertices }) => program.add(vertices)) });
  }
  const elements = list.reduce((sum, { vertices }) => sum + vertices.length / 3, 0);
  const differ = disagreements(programs, cases, list);
  const rounds = programs.map((program) => {
    // The code is compiled and the memory has grown when this round ends.
    seconds(program, cases, 1);
    return Math.max(1, Math.round(kBlockSeconds / seconds(program, cases, 1)));
  });
  const rates = programs.map(() => []);
  for (let pair = 0; pair < Number(asked.pairs); ++pair) {
    programs.forEach((program, i) => {
      rates[i].push((rounds[i] * elements) / seconds(program, cases, rounds[i]));
    });
  }
  return { differ, ours: rates[0], peer: rates[1] };
}

function compareNatively(list, program) {
  const lines = list.map(({ distance, vertices }) =>
    [distance, vertices.length / 3, ...vertices].join(' '),
  );
  return JSON.parse(execFileSync(program, [asked.pairs], { input: lines.join('\n') }));
}

/// Returns the nanoseconds of a call that does nothing.
function emptyCall(program, number) {
  const kCalls = 20_000_000;
  const begun = cpuSeconds();
  for (let i = 0; i < kCalls; ++i) program.nothing(number);
  return ((cpuSeconds() - begun) / kCalls) * 1e9;
}

function inNode() {
  const programs = [new Ours(fs.readFileSync(buildOurs())), new Peer(peerBytes)];
  for (const program of programs) {
    const number = program.add([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    console.log(`an empty call of ${program.name}: ${emptyCall(program, number).toFixed(1)} ns`);
  }
  return (list) => compareInNode(list, programs);
}

function natively() {
  const program = buildNative();
  return (list) => compareNatively(list, program);
}

fs.mkdirSync(here, { recursive: true });
const peerBytes = fs.readFileSync(path.join(here, kPeerFile));
const compare = asked.native ? natively() : inNode();
console.log('million elements/s   ours    peer   ratio   of each pair   cases  differ  panics');
const corpora = Object.entries(kCorpora).map(([name, count]) => [name, () => readCases(name, count)]);
const gears = kGears.map((count) => [`gear ${count}`, () => gear(count)]);
for (const [name, read] of [...corpora, ...gears]) {
  if (asked.only && !name.startsWith(asked.only)) continue;
  const list = read();
  const kept = withoutPanics(list, peerBytes);
  report(name, kept.length, list.length - kept.length, compare(kept));
}
