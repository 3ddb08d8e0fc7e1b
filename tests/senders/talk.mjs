// A conversation with the controller over a pty, TCP or a WebSocket, as a sender sees it: lines,
// acknowledgements, reports. It checks of every line that only acknowledgements contain "ok" or
// "error".

import net from 'node:net';

import { check, load, until } from './support.mjs';

const kAck = /^(ok|error:\d+)$/;

function overTcp(address) {
  const [host, port] = address.split(':');
  const socket = net.connect(Number(port), host);
  socket.setNoDelay(true);
  return {
    open: new Promise((resolve, reject) => socket.once('connect', resolve).once('error', reject)),
    onData: (take) => socket.on('data', take),
    write: (bytes) => socket.write(bytes),
    close: () => socket.destroy(),
  };
}

function overPty(link) {
  const port = new (load('serialport').SerialPort)({ path: link, baudRate: 115200, autoOpen: false });
  return {
    open: new Promise((resolve, reject) => port.open((error) => (error ? reject(error) : resolve()))),
    onData: (take) => port.on('data', take),
    write: (bytes) => port.write(bytes),
    close: () => port.close(),
  };
}

function overWebSocket(address) {
  const socket = new (load('ws'))(`ws://${address}/`);
  return {
    open: new Promise((resolve, reject) => socket.once('open', resolve).once('error', reject)),
    onData: (take) => socket.on('message', (data) => take(Buffer.from(data))),
    write: (bytes) => socket.send(bytes),
    close: () => socket.terminate(),
  };
}

const kTransports = { tcp: overTcp, pty: overPty, ws: overWebSocket };

export class Talk {
  /// Opens a conversation. `kind` is tcp, pty or ws; the address is as `kerfline serve` printed it.
  static async open(kind, address) {
    const talk = new Talk(kTransports[kind](address.replace(/^ws:\/\/|\/$/g, '')));
    await talk.transport.open;
    return talk;
  }

  constructor(transport) {
    this.transport = transport;
    this.lines = [];
    this.acks = 0;
    this.report = null;
    this.text = '';
    transport.onData((data) => this.take(data.toString('latin1')));
  }

  take(text) {
    this.text += text;
    const lines = this.text.split(/\r?\n/);
    this.text = lines.pop();
    for (const line of lines.filter(Boolean)) this.takeLine(line);
  }

  takeLine(line) {
    this.lines.push(line);
    if (kAck.test(line)) this.acks += 1;
    // gSender requests the tag by this name ($EE). Senders that count characters do not.
    else check(!/ok|error/i.test(line.replace(/^\[ERRORCODE:/, '')), `only acknowledgements look like one: ${line}`);
    const report = /^<(.*)>$/.exec(line);
    if (!report) return;
    const [state, ...fields] = report[1].split('|');
    this.report = { state, ...Object.fromEntries(fields.map((field) => field.split(/:(.*)/).slice(0, 2))) };
    // Not every report contains these fields; otherwise the last values apply.
    this.overrides = this.report.Ov ?? this.overrides;
    this.offset = this.report.WCO ?? this.offset;
  }

  write(bytes) {
    this.transport.write(typeof bytes === 'string' ? Buffer.from(bytes, 'latin1') : bytes);
  }

  /// Sends a line and resolves with all lines up to its acknowledgement, inclusively.
  async ask(line, end = '\n', ms = 10_000) {
    const [from, acks] = [this.lines.length, this.acks];
    this.write(line + end);
    await until(`an answer to ${JSON.stringify(line)}`, () => this.acks > acks, ms);
    return this.lines.slice(from).filter((answer) => !answer.startsWith('<'));
  }

  async accepted(line, end = '\n', ms = 10_000) {
    const answer = await this.ask(line, end, ms);
    check(answer.at(-1) === 'ok', `${line} is accepted: ${answer.join(' ')}`);
    return answer.slice(0, -1);
  }

  seen(pattern, ms = 10_000) {
    return until(`a line like ${pattern}`, () => this.lines.find((line) => pattern.test(line)), ms);
  }

  async status() {
    this.report = null;
    this.write('?');
    return until('a report', () => this.report, 5_000);
  }

  state(name, ms = 20_000) {
    return until(`state ${name}`, async () => (await this.status()).state === name, ms);
  }

  async position() {
    return (await this.status()).MPos.split(',').map(Number);
  }

  /// Streams by character counting: never more than `room` bytes are unanswered.
  async stream(lines, room, end = '\n') {
    const first = this.acks;
    const waiting = [];
    let answered = 0;
    const inFlight = () => {
      while (answered < this.acks - first) answered += 1, waiting.shift();
      return waiting.reduce((sum, length) => sum + length, 0);
    };
    for (const line of lines) {
      const bytes = line.length + end.length;
      await until(`room for ${line}`, () => inFlight() + bytes <= room, 60_000);
      waiting.push(bytes);
      this.write(line + end);
    }
    await until('all lines are answered', () => this.acks - first === lines.length, 60_000);
  }

  /// Requests reports until the conversation is closed.
  pollEvery(ms) {
    this.polling = setInterval(() => this.write('?'), ms);
  }

  close() {
    clearInterval(this.polling);
    this.transport.close();
  }
}
