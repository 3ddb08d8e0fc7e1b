// A rough outline of a program, before it runs: what the view draws beneath the
// path. Plain moves and arcs in XY; the controller alone knows the whole language.

const kInch = 25.4;
const kArcStep = Math.PI / 36;

export function outline(text, start, offset) {
  const state = { x: start[0], y: start[1], move: 0, absolute: true, unit: 1, offset };
  const lines = [[[state.x, state.y]]];
  for (const raw of text.split(/\r?\n/)) {
    const words = wordsOf(raw);
    setModes(words, state);
    const moves = words.some(([letter]) => 'XYIJR'.includes(letter));
    if (!moves || state.move === null || words.some(([l, v]) => l === 'G' && [4, 10, 53, 92].includes(v))) continue;
    const points = pointsOf(words, state);
    if (state.move === 0) lines.push([]); // Only what is cut.
    lines.at(-1).push(...points);
    [state.x, state.y] = points.at(-1);
  }
  return lines;
}

function wordsOf(line) {
  const code = line.replace(/\([^)]*\)|;.*$/g, '').replace(/\s+/g, '').toUpperCase();
  return [...code.matchAll(/([A-Z])([-+]?[\d.]+)/g)].map((found) => [found[1], Number(found[2])]);
}

function setModes(words, state) {
  for (const [letter, value] of words) {
    if (letter !== 'G') continue;
    if (value >= 0 && value <= 3) state.move = value;
    if (value === 80) state.move = null;
    if (value === 20) state.unit = kInch;
    if (value === 21) state.unit = 1;
    if (value === 90) state.absolute = true;
    if (value === 91) state.absolute = false;
  }
}

function pointsOf(words, state) {
  const value = (letter) => words.find(([name]) => name === letter)?.[1];
  const end = ['X', 'Y'].map((letter, axis) => {
    const here = axis === 0 ? state.x : state.y;
    const word = value(letter);
    if (word === undefined) return here;
    return word * state.unit + (state.absolute ? state.offset[axis] : here);
  });
  if (state.move < 2) return [end];
  const centre = centreOf(value, end, state);
  return centre ? arc([state.x, state.y], end, centre, state.move === 2) : [end];
}

function centreOf(value, end, state) {
  const radius = value('R');
  if (radius === undefined) {
    return [state.x + (value('I') ?? 0) * state.unit, state.y + (value('J') ?? 0) * state.unit];
  }
  const [dx, dy] = [end[0] - state.x, end[1] - state.y];
  const chord = Math.hypot(dx, dy);
  if (chord === 0) return null;
  const r = radius * state.unit;
  const height = Math.sqrt(Math.max(0, r * r - chord * chord / 4));
  const side = (state.move === 2) === (r > 0) ? 1 : -1;
  return [(state.x + end[0]) / 2 + side * dy / chord * height, (state.y + end[1]) / 2 - side * dx / chord * height];
}

function arc(start, end, centre, clockwise) {
  const angle = (point) => Math.atan2(point[1] - centre[1], point[0] - centre[0]);
  const radius = Math.hypot(start[0] - centre[0], start[1] - centre[1]);
  const first = angle(start);
  let sweep = angle(end) - first;
  if (clockwise && sweep >= -1e-9) sweep -= 2 * Math.PI;
  if (!clockwise && sweep <= 1e-9) sweep += 2 * Math.PI;
  const count = Math.max(1, Math.ceil(Math.abs(sweep) / kArcStep));
  const points = [];
  for (let i = 1; i < count; ++i) {
    const turn = first + sweep * i / count;
    points.push([centre[0] + radius * Math.cos(turn), centre[1] + radius * Math.sin(turn)]);
  }
  return [...points, end];
}
