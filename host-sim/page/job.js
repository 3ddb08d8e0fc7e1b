// A program on its way to the controller.

export class Job extends EventTarget {
  name = '';
  text = '';
  running = false;
  done = 0;
  count = 0;

  async open(file) {
    this.name = file.name;
    this.text = await file.text();
    this.done = this.count = 0;
    this.#tell();
  }

  // Where the program would go if it ran now, as the controller itself reads it.
  async outline() {
    const answer = await fetch('outline', { method: 'POST', body: this.text });
    if (!answer.ok) throw new Error(await answer.text());
    const { points, refused } = await answer.json();
    const place = refused && [this.name, refused.line, refused.column].filter(Boolean).join(':');
    return { points, fault: refused ? `${place}: ${refused.reason}` : '' };
  }

  // Streams the program; ends at its end, at the first refused line or at a reset.
  // The sender keeps the controller's buffer full, we keep the sender's queue short.
  async run(sender) {
    const lines = this.text.split(/\r?\n/).map((line, index) => [line.trim(), index + 1])
      .filter(([line]) => line !== '');
    this.count = lines.length;
    this.done = 0;
    this.running = true;
    this.#tell();
    let fault = null;
    const answers = [];
    for (const [line, number] of lines) {
      if (fault) break;
      answers.push(sender.send(line, true).then((answer) => {
        ++this.done;
        this.#tell();
        if (answer !== 'ok') fault ??= `${this.name}:${number}: ${answer}`;
      }, (reason) => { fault ??= `the job ended: ${reason.message}`; }));
      if (answers.length >= 64) await answers.shift();
    }
    if (fault) sender.dropWaiting();
    await Promise.all(answers);
    this.running = false;
    this.#tell();
    return fault;
  }

  #tell() { this.dispatchEvent(new CustomEvent('change')); }
}
