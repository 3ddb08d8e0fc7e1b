// Sheet that is being edited: stock, parts, positions, and texts of the drawings that were added.
// Drawings have the names that the sheet file uses. An added file is the drawing of all parts whose
// drawing has the same file name, in any folder.

const baseName = (path) => path.split('/').at(-1);
const stem = (path) => baseName(path).replace(/\.[^.]*$/, '');

// Gap between copies that are added, mm.
const kGap = 5;

export class SheetModel {
  sheet = {
    kerfline_sheet: 1,
    stock: { width_mm: 300, height_mm: 200, margin_mm: 5, skeleton: false },
    parts: [],
  };
  drawings = new Map();
  distance = 0.2;
  isChanged = false;

  // Replaces the sheet by one that lists the position of every copy.
  open(sheet) {
    this.sheet = sheet;
    this.isChanged = false;
  }

  add(file, text) {
    const known = this.sheet.parts.filter((part) => baseName(part.drawing) === file);
    if (known.length === 0) {
      this.sheet.parts.push({ drawing: file, name: this.#nameFor(stem(file)), places: [this.#free()] });
      this.isChanged = true;
    }
    for (const name of known.length ? known.map((part) => part.drawing) : [file]) this.drawings.set(name, text);
  }

  isHere(part) { return this.drawings.has(part.drawing); }
  place(chosen) { return chosen && this.sheet.parts[chosen.part]?.places[chosen.copy]; }

  // Adds a copy next to copy `copy` of a part, or at the margin if that copy does not exist.
  // Returns part and number of the new copy.
  another({ part, copy }, width) {
    const places = this.sheet.parts[part].places;
    const like = places[copy] ?? this.#free();
    places.push({ ...like, x_mm: round(like.x_mm + width + kGap) });
    this.isChanged = true;
    return { part, copy: places.length - 1 };
  }

  remove({ part, copy }) {
    this.sheet.parts[part].places.splice(copy, 1);
    if (this.sheet.parts[part].places.length === 0) this.#removePart(part);
    this.isChanged = true;
  }

  change(chosen, values) {
    const place = this.place(chosen);
    Object.assign(place, values);
    if (!place.angle_deg) delete place.angle_deg;
    if (!place.mirror) delete place.mirror;
    this.isChanged = true;
  }

  setStock(values) {
    Object.assign(this.sheet.stock, values);
    this.isChanged = true;
  }

  setLocked(locked) {
    if (locked) this.sheet.locked = true;
    else delete this.sheet.locked;
    this.isChanged = true;
  }

  request() {
    return JSON.stringify({ sheet: this.sheet, drawings: Object.fromEntries(this.drawings), distance_mm: this.distance });
  }
  text() { return `${JSON.stringify(this.sheet, null, 2)}\n`; }

  #free() {
    const margin = this.sheet.stock?.margin_mm ?? 0;
    return { x_mm: margin, y_mm: margin };
  }

  #nameFor(stemOfFile) {
    const taken = new Set(this.sheet.parts.map((part) => part.name));
    let name = stemOfFile;
    for (let i = 2; taken.has(name); ++i) name = `${stemOfFile} ${i}`;
    return name;
  }

  // Removes a part. Also removes it from the `after` lists of other parts.
  #removePart(index) {
    const [gone] = this.sheet.parts.splice(index, 1);
    for (const part of this.sheet.parts) {
      if (!part.after) continue;
      part.after = part.after.filter((name) => name !== gone.name);
      if (part.after.length === 0) delete part.after;
    }
    if (!this.sheet.parts.some((part) => part.drawing === gone.drawing)) this.drawings.delete(gone.drawing);
  }
}

// Rounds to micrometres, so that sums are printed without the digits of rounding errors.
export const round = (mm) => Math.round(mm * 1000) / 1000;
