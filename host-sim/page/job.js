// The job as the server has it: the server sends it, whoever watches. A page opens a program, asks
// for it to be run, and shows how far it is.

export class Job {
  name = '';
  points = []; // The path to come: x, y, move of each vertex, machine coordinates.
  faults = [];

  // Sends a program to the server. Returns what is wrong, empty for nothing.
  async open(file) {
    const text = await file.text();
    return this.#take(await fetch(`job?name=${encodeURIComponent(file.name)}`, { method: 'POST', body: text }));
  }

  // The program that the server has, of this page or another.
  async restore() { return this.#take(await fetch('job')); }

  // Returns why it does not run: {} for a job that does, else { waits } or { faults }.
  run(accepted) { return this.#order('run', JSON.stringify(accepted)); }
  resume() { return this.#order('resume', ''); }
  stop() { return this.#order('stop', ''); }

  async #take(answer) {
    if (!answer.ok) return [await answer.text()];
    const { name, points, faults } = await answer.json();
    Object.assign(this, { name, points, faults });
    return faults;
  }

  async #order(what, body) {
    const answer = await fetch(`job/${what}`, { method: 'POST', body });
    if (answer.ok) return {};
    return answer.status === 409 ? answer.json() : { waits: await answer.text() };
  }
}
