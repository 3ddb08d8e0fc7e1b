// Banner with one sentence, shown until its cause has ended or the operator dismisses it.

export class Notice {
  #element;
  #ends = null;

  constructor(element) {
    this.#element = element;
    element.querySelector('button').onclick = () => this.clear();
  }

  // Shows a sentence. `ends` is called with each news message, and returns whether the cause of the
  // sentence has ended.
  tell(text, ends = () => false) {
    this.#element.querySelector('span').textContent = text;
    this.#element.hidden = false;
    this.#ends = ends;
  }

  clear() {
    this.#element.hidden = true;
    this.#ends = null;
  }

  attend(news) { if (this.#ends?.(news)) this.clear(); }
}
