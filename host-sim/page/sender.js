// G-code sender over the WebSocket of the page. It sends lines by character counting, and realtime
// bytes immediately. While a job of the server runs, the page may send only realtime bytes.

// Line that the server sends instead of a greeting.
const kJobRuns = '[MSG:A job of the page runs]';
const kPageKey = /^\[PAGE:(\w+)\]$/; // Key with which this page orders jobs while it has control.
const kStandardBuffer = 128; // Receive buffer that every Grbl controller has, bytes.

export class Sender extends EventTarget {
  #socket = null;
  #decoder = new TextDecoder();
  #unread = '';
  #buffer = kStandardBuffer;
  #inFlight = []; // Lines that were sent and not answered yet, oldest first.
  #waiting = [];
  #ready = false;
  #page = '';

  get connected() { return this.#socket !== null; }
  get page() { return this.#page; }

  connect() {
    const socket = new WebSocket(`ws://${location.host}/operate`);
    socket.binaryType = 'arraybuffer';
    socket.onmessage = (event) => this.#receive(event.data);
    socket.onclose = (event) => this.#closed(event.code);
    this.#socket = socket;
  }

  disconnect() { this.#socket?.close(); }

  // Sends a realtime command, which acts before the waiting lines.
  realtime(byte) {
    if (this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(new Uint8Array([byte]));
  }

  // Queues a line. Resolves with 'ok' or 'error:N'; rejects if the line is dropped.
  send(line, quiet = false) {
    return new Promise((resolve, reject) => {
      this.#waiting.push({ line, quiet, resolve, reject });
      this.#pump();
    });
  }

  // Drops the lines that were not sent yet.
  dropWaiting() {
    for (const entry of this.#waiting.splice(0)) entry.reject(new Error('dropped'));
  }

  #pump() {
    const used = () => this.#inFlight.reduce((sum, entry) => sum + entry.size, 0);
    while (this.#ready && this.#waiting.length > 0) {
      const entry = this.#waiting[0];
      const bytes = new TextEncoder().encode(entry.line + '\n');
      entry.size = bytes.length;
      if (this.#inFlight.length > 0 && used() + entry.size >= this.#buffer) return;
      this.#inFlight.push(this.#waiting.shift());
      this.#socket.send(bytes);
      if (!entry.quiet) this.#tell('sent', entry.line);
    }
  }

  #receive(data) {
    this.#unread += typeof data === 'string' ? data : this.#decoder.decode(data, { stream: true });
    const lines = this.#unread.split(/\r?\n/);
    this.#unread = lines.pop();
    for (const line of lines) this.#take(line);
  }

  #take(line) {
    const key = kPageKey.exec(line);
    if (key) {
      this.#page = key[1];
      return;
    }
    if (/^Grbl /.test(line)) this.#restarted();
    if (line === kJobRuns) this.#begin();
    if (line.startsWith('<')) return; // Status reports, which the server's job requests.
    const options = /^\[OPT:[^,]*,\d+,(\d+)/.exec(line);
    if (options) this.#buffer = Number(options[1]);
    const isAnswer = line === 'ok' || line.startsWith('error:');
    const entry = isAnswer ? this.#inFlight.shift() : undefined;
    const quiet = line === '' || (line === 'ok' && (!entry || entry.quiet));
    if (!quiet) this.#tell('line', line);
    entry?.resolve(line);
    this.#pump();
  }

  // Drops all lines, because a reset has cleared the controller's buffer.
  #restarted() {
    for (const entry of this.#inFlight.splice(0)) entry.reject(new Error('reset'));
    this.dropWaiting();
    this.#begin();
  }

  #begin() {
    this.#ready = true;
    this.#tell('ready', '');
  }

  #closed(code) {
    this.#socket = null;
    this.#page = '';
    this.#ready = false;
    this.#buffer = kStandardBuffer;
    for (const entry of this.#inFlight.splice(0)) entry.reject(new Error('closed'));
    this.dropWaiting();
    this.#tell('closed', code);
  }

  #tell(type, detail) { this.dispatchEvent(new CustomEvent(type, { detail })); }
}
