// Assembles the page.

const kJump_s = 5;
const kLayers = ["trails", "speeds", "distances", "heat", "list", "shots", "paths", "losses"];

const kLists = ["signals", "clock", "decisions", "chains", "shots", "actions", "winProbabilities"];

// The parts that were appended to the page while the game was played, until the program was killed.
function readParts() {
  const parts = [];
  for (const element of document.querySelectorAll("script.part")) {
    try {
      parts.push(JSON.parse(element.textContent));
    } catch {
      break;  // the last part is incomplete
    }
    element.remove();  // it is large and no longer needed
  }
  return parts;
}

function readGame() {
  const game = JSON.parse(document.getElementById("game").textContent);
  const frames = document.getElementById("frames");
  const parts = [{...game, bytes: frames.textContent}, ...readParts()];
  frames.remove();
  for (const list of kLists) game[list] = parts.flatMap((part) => part[list]);
  const recording = new Recording(game.signals, parts.reduce((sum, part) => sum + part.frames, 0));
  for (const part of parts) recording.append(part);
  return {game, recording};
}

class Page {
  constructor({game, recording}) {
    this.game = game;
    this.recording = recording;
    this.layers = {trails: true, speeds: false, distances: true, heat: false, list: true};
    if (game.chainKinds) this.layers.shots = false;
    if (game.actions.length > 0) Object.assign(this.layers, {paths: false, losses: false});
    this.player = new Player(recording, () => { this.isStale = true; });
    const kicks = kicksOf(game.signals);
    const highlights = highlightsOf(game, kicks);
    const names = shownNames(game.teams);
    const seek = (time_s) => this.player.seek(time_s);
    this.pitch = new Pitch(document.getElementById("pitch"), game, recording);
    this.shootout = new Shootout(kicks, names, seek);
    this.chains = new Chains(game);
    this.scoreboard = new Scoreboard({...game, teams: names}, this.shootout, this.chains);
    this.timeline = new Timeline(recording, highlights, seek);
    this.events = new EventList(highlights, seek);
    if (game.winProbabilities.length > 0) this.beginWinProbability(highlights, seek);
    this.isStale = true;
  }

  begin() {
    this.setTitle();
    this.showFacts();
    this.showFilter();
    if (this.game.chainKinds) this.beginChains();
    this.listen();
    for (const [event, isPaper] of [["beforeprint", true], ["afterprint", false]]) {
      window.addEventListener(event, () => this.print(isPaper));
    }
    new ResizeObserver(() => this.resize()).observe(this.pitch.canvas);
    const frame = (now_ms) => {
      this.player.tick(now_ms);
      if (this.isStale) this.show();
      requestAnimationFrame(frame);
    };
    this.resize();
    this.seekAddress();
    window.addEventListener("hashchange", () => this.seekAddress());
    requestAnimationFrame(frame);
  }

  beginWinProbability(highlights, seek) {
    const winProbability = new WinProbability(this.game);
    const turningPoints = turningPointsOf(winProbability, highlights, this.chains);
    this.winChart = new WinChart(winProbability, turningPoints, this.timeline, seek);
    for (const element of document.querySelectorAll(".ofWin")) element.hidden = false;
  }

  beginChains() {
    const seek = (time_s) => this.player.seek(time_s);
    this.chainStrip = this.newChainStrip(seek);
    this.shotMap = new ShotMap(this.chains, this.game.signals, seek);
    for (const element of document.querySelectorAll(".ofChains")) element.hidden = false;
    if (this.game.actions.length > 0) this.beginActions();
    listenToFilter(this.chains.filter, this.game.chainKinds, () => this.updateChains());
    this.updateChains();
  }

  beginActions() {
    this.actionMap = new ActionMap(this.chains, this.game.signals);
    for (const element of document.querySelectorAll(".ofActions")) element.hidden = false;
    document.getElementById("chainActions").hidden = false;
  }

  newChainStrip(seek) {
    return new ChainStrip(this.chains, this.timeline, seek);
  }

  // Call after the chains, the shots or the filter have changed.
  updateChains() {
    this.chainStrip.update();
    this.shotMap.update();
    this.actionMap?.update();
  }

  // An address that ends in #t=83.2 shows that moment; &with=speeds,heat also shows these layers.
  seekAddress() {
    const address = new URLSearchParams(location.hash.slice(1));
    const time_s = Number(address.get("t") ?? NaN);
    if (Number.isFinite(time_s)) this.player.seek(time_s);
    for (const name of (address.get("with") ?? "").split(",")) {
      if (this.layers[name] === false) this.toggleLayer(name);
    }
  }

  setTitle() {
    const names = this.game.teams.filter(Boolean).join(" - ");
    if (names) document.title = `${names} \u00b7 AutoRef`;
  }

  // Redraws for paper, or for the screen again.
  print(isPaper) {
    drawOnPaper(isPaper);
    this.pitch.drawStill();
    this.show();
  }

  // Shows which game this is and which program made the page.
  showFacts() {
    const facts = document.getElementById("facts");
    for (const [what, value] of this.game.facts) {
      const fact = textElement("span", "fact", `${what} `);
      fact.append(textElement("code", "", value));
      facts.append(fact);
    }
  }

  resize() {
    this.pitch.resize();
    this.show();
    this.events.reveal();
  }

  show() {
    this.isStale = false;
    const {time_s} = this.player;
    const signalIndex = lastNotAfter(this.game.signals, time_s + 1e-6, (signal) => signal.time_s);
    const scene = this.recording.sceneAt(time_s);
    const play = playAt(this.recording, this.game, this.game.signals[signalIndex], scene.index);
    this.pitch.draw(scene, signalIndex, this.layers, this.events.highlightAt(time_s));
    this.scoreboard.show(time_s, this.game.signals[Math.max(signalIndex, 0)], play);
    this.timeline.show(time_s);
    this.winChart?.show(time_s);
    this.chainStrip?.show(time_s);
    this.shotMap?.show(this.layers.shots === true, scene.yellowEnd, this.pitch.pixel_mm);
    this.actionMap?.show(this.layers, scene.yellowEnd, this.pitch.pixel_mm);
    this.events.show(time_s);
    this.showControls();
  }

  showControls() {
    const {player} = this;
    setText("time", hundredths(player.time_s));
    setText("length", minutesAndSeconds(this.recording.last_s));
    setText("speed", `${player.speed}\u00d7`);
    const play = document.getElementById("play");
    play.dataset.playing = String(player.isPlaying);
    play.setAttribute("aria-label", player.isPlaying ? "Pause" : "Play");
    document.getElementById("chain").setAttribute("aria-live", player.isPlaying ? "off" : "polite");
  }

  toggleLayer(name) {
    if (!(name in this.layers)) return;
    this.layers[name] = !this.layers[name];
    document.getElementById(`layer-${name}`).setAttribute("aria-pressed", String(this.layers[name]));
    document.body.classList.toggle("without-list", !this.layers.list);
    this.isStale = true;
  }

  showFilter() {
    const button = document.getElementById("disagreements");
    const count = this.events.highlights.filter((one) => one.isDisagreement).length;
    button.hidden = !this.game.compared;
    button.disabled = count === 0;
    button.textContent = count === 0 ? "No disagreements" : `Only disagreements (${count})`;
  }

  // Lists all events, or only the calls of one referee that the other did not make.
  toggleDisagreements() {
    if (!this.game.compared || document.getElementById("disagreements").disabled) return;
    this.events.hasOnlyDisagreements = !this.events.hasOnlyDisagreements;
    const isOn = this.events.hasOnlyDisagreements;
    document.getElementById("disagreements").setAttribute("aria-pressed", String(isOn));
    document.body.classList.toggle("only-disagreements", isOn);
    this.events.reveal();
  }

  seekMoment(direction, kind) {
    const highlight = this.events.neighbour(this.player.time_s, direction, kind);
    if (highlight) this.player.seek(highlight.time_s);
  }

  seekTurningPoint(direction) {
    const turn = this.winChart?.neighbour(this.player.time_s, direction);
    if (turn) this.player.seek(turn.time_s);
  }

  seekChain(direction) {
    const chain = this.chains.neighbour(this.player.time_s, direction);
    if (chain) this.player.seek(chain.start_s);
  }

  // Selects all chains, or only those with a shot.
  toggleWithShot() {
    const {filter} = this.chains;
    filter.isWithShot = !filter.isWithShot;
    document.getElementById("withShot").setAttribute("aria-pressed", String(filter.isWithShot));
    this.updateChains();
  }

  toggleHelp() {
    const help = document.getElementById("help");
    if (help.open) help.close();
    else help.showModal();
  }

  actions() {
    const {player, recording} = this;
    const actions = {
      toggle: () => player.toggle(),
      back: () => player.seek(player.time_s - kJump_s),
      forward: () => player.seek(player.time_s + kJump_s),
      stepBack: () => player.step(-1),
      stepForward: () => player.step(1),
      slower: () => player.changeSpeed(-1),
      faster: () => player.changeSpeed(1),
      previousEvent: () => this.seekMoment(-1),
      nextEvent: () => this.seekMoment(1),
      previousGoal: () => this.seekMoment(-1, "goal"),
      nextGoal: () => this.seekMoment(1, "goal"),
      previousTurningPoint: () => this.seekTurningPoint(-1),
      nextTurningPoint: () => this.seekTurningPoint(1),
      previousChain: () => this.seekChain(-1),
      nextChain: () => this.seekChain(1),
      withShot: () => this.toggleWithShot(),
      toBegin: () => player.seek(recording.first_s),
      toEnd: () => player.seek(recording.last_s),
      disagreements: () => this.toggleDisagreements(),
      help: () => this.toggleHelp(),
    };
    kLayers.forEach((name, i) => { actions[`layer${i + 1}`] = () => this.toggleLayer(name); });
    return actions;
  }

  // A button's data-action names its action.
  listen() {
    const actions = this.actions();
    for (const button of document.querySelectorAll("[data-action]")) {
      button.addEventListener("click", () => actions[button.dataset.action]());
    }
    this.pitch.canvas.addEventListener("click", actions.toggle);
    listenToKeys(actions);
  }
}
