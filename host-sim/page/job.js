// The job of the server, as the page shows it. The server sends the job to the machine, even if no
// page is open. A page opens a program, orders the server to run it, and shows its progress.

const kAgainMs = 150;

const sleep = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });

export class Job {
  id = ''; // The server's identifier of the program that this page shows.
  name = '';
  points = []; // Path of the job: x, y and move of each vertex, mm in machine coordinates.
  opening = false; // Whether a program is being sent to the server.

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

  // Loads the program that the server has, whichever page opened it. Returns as open() does.
  async restore() { return this.#take(await fetch('job')); }

  // Each of these functions sends an order. It resolves with {} if the server follows the order,
  // otherwise with the reason: { waits } or { faults }. `page` is the key of the page that has
  // control.
  run(page, accepted) { return this.#order('job/run', { id: this.id, page, accepted }); }
  resume(page) { return this.#order('job/resume', { id: this.id, page }); }
  stop(page) { return this.#order('job/stop', { id: this.id, page }); }

  async #take(answer) {
    if (!answer.ok) return { faults: [await answer.text()], count: 1, notes: [] };
    const { id, name, points, faults, fault_count: count, notes } = await answer.json();
    Object.assign(this, { id, name, points });
    return { faults, count, notes: notes ?? [] };
  }

  // Sends an order. Repeats it while the server has not finished its judgement of the program.
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
