// Page on which the user places the parts of a sheet. After each change, the server computes the
// faults and the outlines of the placed parts as `cut` reads them. The page shows both. While the
// user drags a part, the page moves its outlines itself.

import { Notice } from './notice.js';
import { SheetModel, round } from './sheet_model.js';

const at = (id) => document.getElementById(id);
const kSvg = 'http://www.w3.org/2000/svg';
const kNumbers = { x: 'x_mm', y: 'y_mm', angle: 'angle_deg' };
const kStock = { width: 'width_mm', height: 'height_mm', margin: 'margin_mm' };
const kSteps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const model = new SheetModel();
const notice = new Notice(at('notice'));
let chosen = null;
let copies = [];
let asked = 0;
let isDragging = false;

function element(name, attributes) {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

const isChosen = (copy) => chosen && copy.part === chosen.part && copy.copy === chosen.copy;

// Draws a copy. The y axis points upwards in the sheet, and downwards in an SVG.
function drawCopy(copy, height) {
  const group = element('g', { class: isChosen(copy) ? 'copy chosen' : 'copy' });
  const path = copy.outlines.map((points) => {
    const places = [];
    for (let i = 0; i < points.length; i += 2) places.push(`${points[i]} ${height - points[i + 1]}`);
    return `M${places.join('L')}`;
  });
  group.append(element('path', { d: path.join('') }));
  group.addEventListener('pointerdown', (event) => startDrag(event, copy, group));
  return group;
}

function draw() {
  const { width_mm: width, height_mm: height, margin_mm: margin = 0 } = model.sheet.stock;
  const edge = 0.04 * Math.max(width, height);
  const svg = at('sheet');
  svg.setAttribute('viewBox', `${-edge} ${-edge} ${width + 2 * edge} ${height + 2 * edge}`);
  const inner = { x: margin, y: margin, width: Math.max(0, width - 2 * margin), height: Math.max(0, height - 2 * margin) };
  svg.replaceChildren(
    element('rect', { class: 'stock', x: 0, y: 0, width, height }),
    element('rect', { class: 'margin', ...inner }),
    ...copies.map((copy) => drawCopy(copy, height)),
  );
}

function list() {
  at('parts').replaceChildren(...model.sheet.parts.map((part, index) => {
    const item = document.createElement('li');
    const button = document.createElement('button');
    const missing = model.isHere(part) ? '' : ', its drawing is missing: add it';
    button.textContent = `${part.name} × ${part.places.length}${missing}`;
    button.className = missing ? 'missing' : '';
    button.onclick = () => choose({ part: index, copy: 0 });
    item.append(button);
    return item;
  }));
  const count = model.sheet.parts.reduce((sum, part) => sum + part.places.length, 0);
  at('no-parts').hidden = count > 0;
  at('sum').textContent = count === 0 ? '' : `${model.sheet.parts.length} parts, ${count} copies${model.isChanged ? ', not saved' : ''}`;
}

// Shows the values of the sheet in the fields. The focused field keeps its text, unless it is the
// field `refused`, whose text was refused.
function fill(refused = null) {
  const put = (input, value) => {
    if (input === refused || input !== document.activeElement) input.value = value;
  };
  const place = model.place(chosen);
  for (const id of [...Object.keys(kNumbers), 'mirror', 'another', 'remove']) at(id).disabled = !place;
  at('chosen').textContent = place ? `${model.sheet.parts[chosen.part].name} #${chosen.copy + 1}` : 'Nothing chosen';
  for (const [id, key] of Object.entries(kNumbers)) put(at(id), place ? place[key] ?? 0 : '');
  at('mirror').checked = Boolean(place?.mirror);
  for (const [id, key] of Object.entries(kStock)) put(at(id), model.sheet.stock[key] ?? 0);
  put(at('distance'), model.distance);
  at('skeleton').checked = Boolean(model.sheet.stock.skeleton);
  at('locked').checked = Boolean(model.sheet.locked);
}

function show() {
  draw();
  list();
  fill();
}

function tell(faults) {
  at('faults').replaceChildren(...faults.map((fault) => {
    const item = document.createElement('li');
    item.textContent = fault;
    return item;
  }));
  at('no-faults').hidden = faults.length > 0;
}

async function post(body) {
  const reply = await fetch('sheet', { method: 'POST', body });
  if (!reply.ok) throw new Error(await reply.text());
  return reply.json();
}

const waits = (isBusy) => at('sheet').setAttribute('aria-busy', isBusy);

// Requests outlines and faults from the server. Only the answer to the last request is used.
async function refresh() {
  show();
  const number = ++asked;
  if (model.sheet.parts.length === 0) {
    copies = [];
    tell([]);
    waits(false);
    return show();
  }
  waits(true);
  try {
    const reply = await post(model.request());
    if (number !== asked) return;
    copies = reply.copies ?? [];
    tell(reply.faults);
    if (!isDragging) show();
    waits(false);
  } catch (error) {
    waits(false);
    notice.tell(`The server does not answer: ${error.message}`);
  }
}

function choose(copy) {
  chosen = copy;
  show();
}

// Moves the outlines of the chosen copy immediately. The server's answer replaces them later.
function shift(dx, dy) {
  for (const copy of copies.filter(isChosen)) {
    copy.outlines = copy.outlines.map((points) => points.map((mm, i) => mm + (i % 2 === 0 ? dx : dy)));
  }
}

function change(values) {
  const place = model.place(chosen);
  if (!place) return;
  shift((values.x_mm ?? place.x_mm) - place.x_mm, (values.y_mm ?? place.y_mm) - place.y_mm);
  model.change(chosen, values);
  refresh();
}

function move([dx, dy], step) {
  const place = model.place(chosen);
  if (place) change({ x_mm: round(place.x_mm + dx * step), y_mm: round(place.y_mm + dy * step) });
}

function widthOfChosen() {
  const xs = copies.filter(isChosen).flatMap((copy) => copy.outlines.flat().filter((_, i) => i % 2 === 0));
  return xs.length ? round(Math.max(...xs) - Math.min(...xs)) : 10;
}

function startDrag(event, copy, group) {
  event.preventDefault();
  isDragging = true;
  chosen = { part: copy.part, copy: copy.copy };
  const svg = at('sheet');
  const scale = svg.getScreenCTM().a;
  const from = { x: event.clientX, y: event.clientY };
  const place = model.place(chosen);
  const way = (to) => [(to.clientX - from.x) / scale, (from.y - to.clientY) / scale];
  svg.setPointerCapture(event.pointerId);
  svg.onpointermove = (to) => group.setAttribute('transform', `translate(${way(to)[0]} ${-way(to)[1]})`);
  svg.onpointerup = (to) => {
    svg.onpointermove = svg.onpointerup = svg.onpointercancel = null;
    isDragging = false;
    const [dx, dy] = way(to);
    if (Math.hypot(dx, dy) * scale < 2) return choose(chosen);
    change({ x_mm: round(place.x_mm + dx), y_mm: round(place.y_mm + dy) });
  };
  svg.onpointercancel = () => {
    svg.onpointermove = svg.onpointerup = svg.onpointercancel = null;
    isDragging = false;
    show();
  };
  fill();
  svg.focus();
}

async function openSheet(file) {
  let sheet;
  try {
    sheet = JSON.parse(await file.text());
  } catch (error) {
    return notice.tell(`${file.name} is not opened: ${error.message}`);
  }
  // The reply omits parts with faults. If it omits a part, the sheet is not opened, because saving
  // it would lose this part.
  const reply = await post(JSON.stringify({ sheet, drawings: {} }));
  const count = Array.isArray(sheet?.parts) ? sheet.parts.length : -1;
  if (reply.sheet?.parts.length !== count || !reply.sheet.stock) {
    return notice.tell(`${file.name} is not opened: ${reply.faults.find((fault) => !/ is not here/.test(fault)) ?? 'it is no sheet'}`);
  }
  model.open(reply.sheet);
  at('sheet-name').textContent = file.name;
  chosen = null;
  return refresh();
}

async function addDrawings(files) {
  for (const file of files) model.add(file.name, await file.text());
  chosen = model.sheet.parts.length ? { part: model.sheet.parts.length - 1, copy: 0 } : null;
  return refresh();
}

function save() {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([model.text()], { type: 'application/json' }));
  link.download = at('sheet-name').textContent === 'new' ? 'sheet.json' : at('sheet-name').textContent;
  link.click();
  URL.revokeObjectURL(link.href);
  at('sheet-name').textContent = link.download;
  model.isChanged = false;
  list();
}

function remove() {
  if (!model.place(chosen)) return;
  model.remove(chosen);
  chosen = null;
  refresh();
}

// Calls `act` after each change of a field, with the number in the field. If the text is no number
// in the range of the field, the browser reports this, and the earlier value is restored.
const whenValid = (input, act) => {
  input.onchange = () => (input.reportValidity() && input.value !== '' ? act(Number(input.value)) : fill(input));
};

for (const [id, key] of Object.entries(kNumbers)) whenValid(at(id), (value) => change({ [key]: value }));
for (const [id, key] of Object.entries(kStock)) {
  whenValid(at(id), (value) => {
    model.setStock({ [key]: value });
    refresh();
  });
}
whenValid(at('distance'), (value) => {
  model.distance = value;
  refresh();
});
at('mirror').onchange = () => change({ mirror: at('mirror').checked });
at('skeleton').onchange = () => { model.setStock({ skeleton: at('skeleton').checked }); refresh(); };
at('locked').onchange = () => { model.setLocked(at('locked').checked); refresh(); };
at('another').onclick = () => { chosen = model.another(chosen, widthOfChosen()); refresh(); };
at('remove').onclick = remove;
at('save').onclick = save;
at('sheet-file').onchange = (event) => openSheet(event.target.files[0]).finally(() => { event.target.value = ''; });
at('drawing-files').onchange = (event) => addDrawings([...event.target.files]).finally(() => { event.target.value = ''; });
at('sheet').onkeydown = (event) => {
  const place = model.place(chosen);
  if (!place || event.ctrlKey || event.metaKey) return;
  const step = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
  if (kSteps[event.key]) move(kSteps[event.key], step);
  else if (event.key.toLowerCase() === 'r') change({ angle_deg: ((place.angle_deg ?? 0) + 90) % 360 });
  else if (event.key.toLowerCase() === 'm') change({ mirror: !place.mirror });
  else if (event.key === 'Delete') remove();
  else return;
  event.preventDefault();
};
window.onbeforeunload = (event) => { if (model.isChanged) event.preventDefault(); };
refresh();
