// The last lines of the conversation between the page and the controller.

import { answerWords } from './words.js';

const kMaxLines = 400;

export class Log {
  #element;

  constructor(element) { this.#element = element; }

  sent(text) { this.#add('b', `> ${text}`); }
  answer(text) { this.#add(/^(error|ALARM):/.test(text) ? 'em' : 'span', answerWords(text)); }

  #add(kind, text) {
    const line = document.createElement(kind);
    line.textContent = `${text}\n`;
    this.#element.append(line);
    while (this.#element.childElementCount > kMaxLines) this.#element.firstElementChild.remove();
    this.#element.scrollTop = this.#element.scrollHeight;
  }
}
