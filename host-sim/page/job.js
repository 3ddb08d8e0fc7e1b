// The job as the server has it. The server sends it, with or without a page. A page opens a program,
// orders it to be run, and shows how far it is.

const kAgainMs = 150;

const sleep = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });

export class Job {
  id = ''; // The program that this page shows, as the server names it.
  name = '';
  points = []; // The path to come: x, y, move of each vertex, machine coordinates.
  opening = false; // A program is on its way to the server.

  // Sends a program to the server. Returns { faults, count, notes }.
  async open(file) {
    this.opening = true;
    try {
      const text = await file.arrayBuffer();
      return await this.#take(await fetch(`job?name=${encodeURIComponent(file.name)}`, { method: 'POST', body: text }));
    } finally {
      this.opening = false;
    }
  }

  // The program that the server has, of this page or another.
  async restore() { return this.#take(await fetch('job')); }

  // Each returns why it does not happen: {} for what does, else { waits } or { faults }. `page` is
  // the key of the page that has control.
  run(page, accepted) { return this.#order('job/run', { id: this.id, page, accepted }); }
  resume(page) { return this.#order('job/resume', { id: this.id, page }); }
  stop(page) { return this.#order('job/stop', { id: this.id, page }); }

  async #take(answer) {
    if (!answer.ok) return { faults: [await answer.text()], count: 1, notes: [] };
    const { id, name, points, faults, fault_count: count, notes } = await answer.json();
    Object.assign(this, { id, name, points });
    return { faults, count, notes: notes ?? [] };
  }

  // The server judges a long program in a thread of its own: it is asked again until that is done.
  async #order(path, order) {
    for (;;) {
      const answer = await fetch(path, { method: 'POST', body: JSON.stringify(order) });
      if (answer.ok) return {};
      if (answer.status !== 409) return { waits: await answer.text() };
      const reason = await answer.json();
      if (!reason.again) return reason;
      await sleep(kAgainMs);
    }
  }
}
