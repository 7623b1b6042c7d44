// Team names, score, expected goals and clock, and whether the ball is in play or which command applies.

function setText(id, text) {
  const element = document.getElementById(id);
  if (element.textContent !== text) element.textContent = text;
}

const kPlayTitles = {in: "In play", out: "Out of play"};

function signOf(signal, play) {
  if (kindOfCommand(signal.command) === "HALT") return "halt";
  return play === "in" ? "running" : "stopped";
}

class Scoreboard {
  constructor({teams, signals, clock}, shootout, chains) {
    this.chains = chains;
    this.shootout = shootout;
    this.signals = signals;
    this.clock = clock;
    teams.forEach((name, side) => {
      setText(`team${side}`, name);
      document.getElementById(`team${side}`).title = name;
    });
  }

  // `play` is a value of playAt().
  show(time_s, signal, play) {
    setText("clock", this.clockAt(time_s));
    setText("xg", `xG ${this.chains.xgAt(time_s).map((xg) => xg.toFixed(2)).join(" : ")}`);
    if (!signal) return;
    const standing = this.shootout.standingAt(time_s);
    for (const side of [0, 1]) {
      setText(`goals${side}`, signal.goals[side] + (standing ? ` (${standing[side]})` : ""));
      this.showCards(signal, side);
    }
    setText("stage", stageTitle(signal.stage));
    this.showCommand(signal, play);
  }

  showCommand(signal, play) {
    const title = commandTitle(signal.command);
    const pill = document.getElementById("command");
    setText("command", kPlayTitles[play] ?? title);
    pill.title = `Last command: ${title}`;
    pill.dataset.sign = signOf(signal, play);
    pill.dataset.side = kPlayTitles[play] ? "" : sideOfCommand(signal.command) ?? "";
  }

  showCards(signal, side) {
    const yellow = signal.yellowCards[side];
    const red = signal.redCards[side];
    setText(`yellowCards${side}`, yellow > 0 ? String(yellow) : "");
    setText(`redCards${side}`, red > 0 ? String(red) : "");
  }

  // Remaining time of the stage; empty if unknown.
  clockAt(time_s) {
    const place = lastNotAfter(this.clock, time_s, ([since_s]) => since_s);
    if (place < 0) return "";
    const left_s = this.clock[place][1];
    return left_s === 0 && !this.clock.some(([, left]) => left !== 0) ? "" : minutesAndSeconds(left_s);
  }
}
