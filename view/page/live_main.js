// Assembles the page of a live game.

const kMarksEvery_ms = 500;
const kHeatEvery_ms = 5000;

kKeys.l = "live";

function forgetOldest(list, most) {
  if (list.length > most) list.splice(0, list.length - most);
}

class LivePage extends Page {
  constructor(game) {
    const recording = new LiveRecording(game.signals);
    super({game, recording});
    this.player = new LivePlayer(recording, () => { this.isStale = true; });
    const seek = (time_s) => this.player.seek(time_s);
    this.timeline = new LiveTimeline(recording, seek);
    this.events = new LiveEventList(seek);
    this.isLoading = true;  // until all earlier messages have arrived
    this.drawn = 0;  // frames, for tests and measurements
  }

  begin() {
    super.begin();
    setInterval(() => {
      this.timeline.moveMarks();
      this.chainStrip?.moveSegments();
    }, kMarksEvery_ms);
    setInterval(() => { this.pitch.heat = null; }, kHeatEvery_ms);
  }

  // Called when the server starts to send the game from its beginning again.
  restart() {
    for (const list of [this.game.signals, this.game.clock, this.game.decisions]) list.length = 0;
    this.recording.clear();
    this.chains.clear();
    this.areChainsStale = true;
    this.isLoading = true;
    this.player.isWaiting = true;
  }

  loaded() {
    this.isLoading = false;
    this.player.isWaiting = false;
    this.isStale = true;
  }

  add(part) {
    const {game} = this;
    for (const list of ["signals", "clock", "decisions"]) {
      game[list].push(...part[list]);
      forgetOldest(game[list], game.limits[list]);
    }
    this.recording.append(part);
    this.addChains(part);
    if (part.signals.length > 0 || part.decisions.length > 0) this.areCallsStale = true;
    this.isStale = true;
  }

  addChains({chains, shots}) {
    if (chains.length + shots.length === 0) return;
    this.chains.add(chains, shots);
    forgetOldest(this.chains.chains, this.game.limits.chains);
    forgetOldest(this.chains.shots, this.game.limits.shots);
    this.areChainsStale = true;
  }

  newChainStrip(seek) {
    return new LiveChainStrip(this.chains, this.timeline, seek);
  }

  updateChains() {
    this.areChainsStale = false;
    super.updateChains();
  }

  updateCalls() {
    this.areCallsStale = false;
    const kicks = kicksOf(this.game.signals);
    const highlights = highlightsOf(this.game, kicks);
    this.showKicks(kicks);
    this.timeline.update(highlights);
    this.events.update(highlights);
  }

  showKicks(kicks) {
    const box = document.getElementById("shootout");
    box.replaceChildren();
    box.hidden = true;
    this.shootout = new Shootout(kicks, shownNames(this.game.teams), (time_s) => this.player.seek(time_s));
    this.scoreboard.shootout = this.shootout;
  }

  show() {
    if (this.isLoading || this.recording.count === 0) return;
    if (this.areCallsStale) this.updateCalls();
    if (this.areChainsStale) this.updateChains();
    super.show();
    ++this.drawn;
  }

  showControls() {
    super.showControls();
    document.getElementById("live").setAttribute("aria-pressed", String(this.player.isFollowing));
  }

  actions() {
    return {...super.actions(), live: () => this.player.follow()};
  }
}

// The button that follows the game, and the state of the connection.
function addLiveControls() {
  const button = textElement("button", "", "Live");
  button.type = "button";
  button.id = "live";
  button.title = "Follow the game (l)";
  button.dataset.action = "live";
  document.querySelector(".times").after(button);
  const state = textElement("p", "", "");
  state.id = "connection";
  state.setAttribute("role", "status");
  document.querySelector(".pitch").append(state);
  document.querySelector("#help dl").append(textElement("dt", "", ""), textElement("dd", "", "follow the game"));
  document.querySelector("#help dt:last-of-type").append(textElement("kbd", "", "l"));
}

let page = null;

function takeMessage(message) {
  if (message.type === "part") return page.add(message);
  if (message.type === "present") return page.loaded();
  if (message.type !== "start") return;
  if (page === null) {
    page = new LivePage(message);
    page.begin();
  } else if (page.game.id === message.id) {
    page.restart();
  } else {
    location.reload();
  }
}

addLiveControls();
new Connection(takeMessage, (text) => setText("connection", text)).open();
