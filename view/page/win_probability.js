// The win probability of a simulated game: a chart below the timeline, and the turning points, which
// moved it most.

const kMostTurningPoints = 5;
const kBeforeTurn_s = 4;  // a change is measured from this time before to kAfterTurn_s after it
const kAfterTurn_s = 1;
const kLeastChange = 0.03;  // smaller changes are not listed, as a share of a win

// The elements of an array (view/page.cpp). Blue wins otherwise.
function winProbabilityOf([time_s, yellow, draw]) {
  return {time_s, yellow, draw, blue: Math.max(0, 1 - yellow - draw)};
}

// Yellow's share of a win; a draw is half a win.
function shareOfYellow({yellow, draw}) {
  return yellow + draw / 2;
}

class WinProbability {
  constructor({winProbabilities}) {
    this.list = winProbabilities.map(winProbabilityOf);
  }

  // The last estimate up to this time; the first one before that.
  at(time_s) {
    return this.list[Math.max(0, lastNotAfter(this.list, time_s + kSameMoment_s, (one) => one.time_s))];
  }

  // How much yellow's share changes around this time.
  changeAround(time_s) {
    return shareOfYellow(this.at(time_s + kAfterTurn_s)) - shareOfYellow(this.at(time_s - kBeforeTurn_s));
  }

  // The time of the largest step in this change around this time.
  steepestTime({time_s, change}) {
    const step = (i) => Math.sign(change) * (shareOfYellow(this.list[i]) - shareOfYellow(this.list[i - 1]));
    let steepest = null;
    for (let i = 1; i < this.list.length; ++i) {
      const isInside = this.list[i].time_s > time_s - kBeforeTurn_s && this.list[i].time_s <= time_s + kAfterTurn_s;
      if (isInside && (steepest === null || step(i) > step(steepest))) steepest = i;
    }
    return steepest === null ? time_s : this.list[steepest].time_s;
  }

  // The largest changes, in the order of time, not closer together than a change lasts.
  largestChanges() {
    const changes = this.list.map(({time_s}) => ({time_s, change: this.changeAround(time_s)}))
      .filter(({change}) => Math.abs(change) >= kLeastChange)
      .sort((one, other) => Math.abs(other.change) - Math.abs(one.change));
    const chosen = [];
    for (const one of changes) {
      const isApart = chosen.every(({time_s}) => Math.abs(time_s - one.time_s) > kBeforeTurn_s + kAfterTurn_s);
      if (isApart && chosen.length < kMostTurningPoints) chosen.push(one);
    }
    return chosen.map((one) => ({...one, time_s: this.steepestTime(one)})).sort((one, other) => one.time_s - other.time_s);
  }
}

// What happened at this time: a goal or a card, or else the chain of the best shot, another call, or the chain in
// progress.
function eventAround(time_s, highlights, {chains, shots}) {
  const from_s = time_s - kBeforeTurn_s;
  const to_s = time_s + kAfterTurn_s;
  const isNear = (one) => one.time_s > from_s && one.time_s <= to_s;
  const calls = ["goal", "card", "stop"].map((kind) => highlights.find((one) => one.kind === kind && isNear(one)));
  const [best] = shots.filter((shot) => isNear(shot) && shot.chain).sort((one, other) => other.xg - one.xg);
  const played = chains.find((chain) => chain.end_s > from_s && chain.start_s <= to_s);
  const [goal, card, stop] = calls;
  const call = goal ?? card ?? (best ? undefined : stop);
  const chain = best?.chain ?? played;
  return call?.title ?? (chain ? chainTitle(chain) : "");
}

// The turning points as highlights (highlights.js) that begin before the change. The reason is the result whose
// probability has changed most in favour of the side.
function turningPointsOf(winProbability, highlights, chains) {
  return winProbability.largestChanges().map(({time_s, change}) => {
    const side = change > 0 ? 0 : 1;
    const color = kSideNames[side];
    const [before, after] = [time_s - kBeforeTurn_s, time_s + kAfterTurn_s].map((at_s) => winProbability.at(at_s));
    const isDraw = after.draw - before.draw > after[color] - before[color];
    const result = isDraw ? "draw" : color;
    return {
      time_s: Math.max(0, time_s - kBeforeTurn_s),
      changed_s: time_s,
      kind: "turningPoint",
      side,
      title: eventAround(time_s, highlights, chains) || `Better for ${color}`,
      reason: `${isDraw ? "Draw" : `${capitalised(color)} wins`}: ${percent(before[result])} before, ${percent(after[result])} after.`,
    };
  });
}

function percent(share) {
  return `${Math.round(100 * share)} %`;
}

class WinChart {
  // Calls `seek(time_s)` when the user picks a time or a turning point.
  constructor(winProbability, turningPoints, timeline, seek) {
    this.winProbability = winProbability;
    this.turningPoints = turningPoints;
    this.timeline = timeline;
    this.seek = seek;
    this.chart = document.getElementById("winChart");
    this.now = document.getElementById("winNow");
    this.draw();
    this.addTurningPoints();
    this.chart.addEventListener("click", (event) => seek(timeline.timeUnder(event)));
    this.chart.addEventListener("pointermove", (event) => {
      this.chart.setAttribute("aria-description", this.chart.title = this.text(timeline.timeUnder(event)));
    });
  }

  // Yellow's area lies above, blue's below, as in the strip of possession chains.
  draw() {
    const points = (shareOf) => this.winProbability.list
      .map((one) => `${(1000 * this.timeline.shareOf(one.time_s)).toFixed(1)},${(100 * shareOf(one)).toFixed(1)}`);
    const yellow = points((one) => one.yellow);
    const blue = points((one) => one.yellow + one.draw);
    document.getElementById("winYellow").setAttribute("points", ["0,0", ...yellow, `${yellow.at(-1).split(",")[0]},0`].join(" "));
    document.getElementById("winBlue").setAttribute("points", ["0,100", ...blue, `${blue.at(-1).split(",")[0]},100`].join(" "));
  }

  addTurningPoints() {
    const items = this.turningPoints.map((turn) => highlightItem(turn, this.seek));
    document.getElementById("turningPointList").append(...items);
    document.getElementById("turningPoints").hidden = items.length === 0;
    for (const {side, changed_s} of this.turningPoints) {
      const mark = textElement("span", "turn", "");
      mark.dataset.side = String(side);
      mark.style.left = `${100 * this.timeline.shareOf(changed_s)}%`;
      this.chart.append(mark);
    }
  }

  // The next turning point, forwards (1) or backwards (-1); undefined if there is none.
  neighbour(time_s, direction) {
    const ahead = this.turningPoints.filter((turn) => direction * (turn.time_s - time_s) > kSameMoment_s);
    return direction > 0 ? ahead[0] : ahead.at(-1);
  }

  text(time_s) {
    const {yellow, draw, blue} = this.winProbability.at(time_s);
    return `Yellow wins ${percent(yellow)}, draw ${percent(draw)}, blue wins ${percent(blue)}`;
  }

  show(time_s) {
    const {yellow, blue} = this.winProbability.at(time_s);
    this.now.style.left = `${100 * this.timeline.shareOf(time_s)}%`;
    setText("win", `win ${percent(yellow)} : ${percent(blue)}`);
  }
}
