// Canvas that shows the path driven so far, coloured by speed, the path of the job, and the tool.

const kMargin = 0.08; // Margin around the fitted paths, as a share of the canvas.
const kTravel = 0;
const kCut = 2;

export function speedColour(share) {
  const hue = 225 - 215 * Math.min(1, Math.max(0, share));
  return `hsl(${hue} 78% 50%)`;
}

export class View {
  path = [];
  job = []; // Path of the job: x, y and move of each vertex, mm in machine coordinates.
  news = null;
  #canvas;
  #scale = 1;
  #centre = [0, 0];
  #fitted = true;
  #style = {};

  constructor(canvas) {
    this.#canvas = canvas;
    new ResizeObserver(() => this.draw()).observe(canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(event.deltaY < 0 ? 1.2 : 1 / 1.2);
    }, { passive: false });
    canvas.addEventListener('pointermove', (event) => {
      if (event.buttons === 0) return;
      this.#fitted = false;
      this.#centre[0] -= event.movementX / this.#scale;
      this.#centre[1] += event.movementY / this.#scale;
      this.draw();
    });
  }

  fit() { this.#fitted = true; this.draw(); }

  zoom(factor) {
    this.#fitted = false;
    this.#scale *= factor;
    this.draw();
  }

  get fastest() {
    let fastest = 0;
    for (let i = 2; i < this.path.length; i += 4) fastest = Math.max(fastest, this.path[i]);
    return fastest;
  }

  draw() {
    const canvas = this.#canvas;
    const ratio = devicePixelRatio || 1;
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    const style = getComputedStyle(document.documentElement);
    for (const name of ['grid', 'travel', 'tool', 'line', 'quiet', 'accent']) {
      this.#style[name] = style.getPropertyValue(`--${name}`);
    }
    if (this.#fitted) this.#fit();
    const context = canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
    this.#drawGrid(context);
    this.#drawJob(context);
    this.#drawPath(context);
    this.#drawTool(context);
  }

  // Returns the position of the machine zero in the coordinates of the path, which are motor
  // positions since power-up.
  #origin() {
    const news = this.news;
    return news ? [0, 1].map((axis) => news.motors[axis] - news.mpos[axis]) : [0, 0];
  }

  #bounds() {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    const add = (x, y) => {
      box[0] = Math.min(box[0], x); box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x); box[3] = Math.max(box[3], y);
    };
    const [ox, oy] = this.#origin();
    for (let i = 0; i < this.path.length; i += 4) add(this.path[i], this.path[i + 1]);
    for (let i = 0; i < this.job.length; i += 3) add(this.job[i] + ox, this.job[i + 1] + oy);
    if (this.news) add(this.news.motors[0], this.news.motors[1]);
    if (box[0] > box[2]) return [0, 0, 100, 100];
    if (box[2] - box[0] < 1 && box[3] - box[1] < 1) return [box[0] - 50, box[1] - 50, box[2] + 50, box[3] + 50];
    return box;
  }

  #fit() {
    const [left, low, right, high] = this.#bounds();
    const room = 1 - 2 * kMargin;
    this.#scale = Math.min(this.#canvas.clientWidth * room / Math.max(right - left, 1),
      this.#canvas.clientHeight * room / Math.max(high - low, 1));
    this.#centre = [(left + right) / 2, (low + high) / 2];
  }

  #at(x, y) {
    return [this.#canvas.clientWidth / 2 + (x - this.#centre[0]) * this.#scale,
      this.#canvas.clientHeight / 2 - (y - this.#centre[1]) * this.#scale];
  }

  #drawGrid(context) {
    const wanted = 60 / this.#scale;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= wanted);
    const { clientWidth: width, clientHeight: height } = this.#canvas;
    const [ox, oy] = this.#origin();
    context.font = '11px system-ui, "DejaVu Sans", sans-serif';
    context.fillStyle = this.#style.quiet;
    const lines = (centre, span, origin, draw) => {
      const first = Math.ceil((centre - span / 2 - origin) / step);
      const last = Math.floor((centre + span / 2 - origin) / step);
      for (let n = first; n <= last; ++n) {
        context.strokeStyle = n === 0 ? this.#style.accent : this.#style.grid;
        context.beginPath();
        draw(n * step + origin, Number((n * step).toPrecision(8)));
        context.stroke();
      }
    };
    context.lineWidth = 1;
    lines(this.#centre[0], width / this.#scale, ox, (x, name) => {
      const place = Math.round(this.#at(x, 0)[0]) + 0.5;
      context.moveTo(place, 0); context.lineTo(place, height);
      context.fillText(name, place + 3, height - 5);
    });
    lines(this.#centre[1], height / this.#scale, oy, (y, name) => {
      const place = Math.round(this.#at(0, y)[1]) + 0.5;
      context.moveTo(0, place); context.lineTo(width, place);
      context.fillText(name, 4, place - 3);
    });
  }

  // Draws the path of the job without its travel moves.
  #drawJob(context) {
    const [ox, oy] = this.#origin();
    context.strokeStyle = this.#style.line;
    context.lineWidth = 2;
    context.beginPath();
    for (let i = 0; i < this.job.length; i += 3) {
      const place = this.#at(this.job[i] + ox, this.job[i + 1] + oy);
      if (this.job[i + 2] === kTravel) context.moveTo(...place); else context.lineTo(...place);
    }
    context.stroke();
  }

  // Draws the path driven so far. Consecutive moves of the same colour are one stroke of the
  // canvas.
  #drawPath(context) {
    const fastest = this.fastest || 1;
    let colour = null;
    for (let i = 4; i < this.path.length; i += 4) {
      const [x, y, speed, move] = this.path.slice(i, i + 4);
      const next = move === kCut ? speedColour(Math.round(speed / fastest * 24) / 24) : this.#style.travel;
      if (next !== colour) {
        if (colour !== null) context.stroke();
        colour = next;
        context.beginPath();
        context.strokeStyle = colour;
        context.lineWidth = move === kCut ? 1.8 : 1;
        context.setLineDash(move === kTravel ? [4, 4] : []);
        context.moveTo(...this.#at(this.path[i - 4], this.path[i - 3]));
      }
      context.lineTo(...this.#at(x, y));
    }
    if (colour !== null) context.stroke();
    context.setLineDash([]);
  }

  #drawTool(context) {
    if (!this.news) return;
    const [x, y] = this.news.motors;
    const [toolX, toolY] = this.#at(x, y);
    const burning = this.news.power > 0;
    context.strokeStyle = context.fillStyle = burning ? this.#style.tool : this.#style.quiet;
    context.lineWidth = 2;
    const end = this.path.length - 4;
    if (end >= 0) {
      context.beginPath();
      context.moveTo(...this.#at(this.path[end], this.path[end + 1]));
      context.lineTo(toolX, toolY);
      context.stroke();
    }
    context.beginPath();
    context.arc(toolX, toolY, 7, 0, 2 * Math.PI);
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      context.moveTo(toolX + 4 * dx, toolY + 4 * dy);
      context.lineTo(toolX + 13 * dx, toolY + 13 * dy);
    }
    context.stroke();
    if (!burning) return;
    context.beginPath();
    context.arc(toolX, toolY, 3, 0, 2 * Math.PI);
    context.fill();
  }
}
