// Receives the news that the server sends to all watchers. Reconnects if the connection is lost.

const kRetryMs = 1000;

export class Observer extends EventTarget {
  // Path that was driven so far: x, y (mm), speed (mm/s) and move (kind of motion) of each vertex.
  path = [];

  constructor() {
    super();
    this.#connect();
  }

  #connect() {
    const socket = new WebSocket(`ws://${location.host}/observe`);
    socket.onmessage = (event) => this.#receive(JSON.parse(event.data));
    socket.onclose = () => {
      this.dispatchEvent(new CustomEvent('lost'));
      setTimeout(() => this.#connect(), kRetryMs);
    };
  }

  #receive(news) {
    if (news.refused) {
      this.dispatchEvent(new CustomEvent('refused', { detail: news.refused }));
      return;
    }
    this.path.length = Math.min(this.path.length, news.path.from * 4);
    for (const number of news.path.points) this.path.push(number);
    this.dispatchEvent(new CustomEvent('news', { detail: news }));
  }
}
