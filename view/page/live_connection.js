// The connection to the server. Whenever it is lost, it is opened again after growing pauses.

const kFirstPause_ms = 500;
const kLongestPause_ms = 10000;

class Connection {
  // `onMessage(message)` receives each message, and `onState(text)` a sentence for the user or "".
  constructor(onMessage, onState) {
    this.onMessage = onMessage;
    this.onState = onState;
    this.pause_ms = kFirstPause_ms;
    this.isOver = false;
  }

  open() {
    if (!this.isOver) this.onState("Connecting \u2026");
    this.socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/live`);
    this.socket.addEventListener("message", ({data}) => this.take(JSON.parse(data)));
    this.socket.addEventListener("close", () => this.openLater());
  }

  take(message) {
    if (message.type === "start") {
      this.pause_ms = kFirstPause_ms;
      this.isOver = false;
      this.onState("");
    }
    if (message.type === "over") {
      this.isOver = true;
      this.onState(message.text);
    }
    this.onMessage(message);
  }

  openLater() {
    if (!this.isOver) this.onState(`The connection is lost. Next attempt in ${Math.ceil(this.pause_ms / 1000)} s.`);
    setTimeout(() => this.open(), this.pause_ms);
    this.pause_ms = Math.min(2 * this.pause_ms, kLongestPause_ms);
  }
}
