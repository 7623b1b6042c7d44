// Team names, score, clock, and the referee's command.

function setText(id, text) {
  const element = document.getElementById(id);
  if (element.textContent !== text) element.textContent = text;
}

function signOf(signal) {
  const kind = kindOfCommand(signal.command);
  if (kind === "HALT") return "halt";
  return isRunning(signal) ? "running" : "stopped";
}

class Scoreboard {
  constructor({teams, signals, clock}, shootout) {
    this.shootout = shootout;
    this.signals = signals;
    this.clock = clock;
    teams.forEach((name, side) => {
      setText(`team${side}`, name);
      document.getElementById(`team${side}`).title = name;
    });
  }

  show(time_s, signal) {
    setText("clock", this.clockAt(time_s));
    if (!signal) return;
    const standing = this.shootout.standingAt(time_s);
    for (const side of [0, 1]) {
      setText(`goals${side}`, signal.goals[side] + (standing ? ` (${standing[side]})` : ""));
      this.showCards(signal, side);
    }
    setText("stage", stageTitle(signal.stage));
    setText("command", commandTitle(signal.command));
    document.getElementById("command").dataset.sign = signOf(signal);
    document.getElementById("command").dataset.side = sideOfCommand(signal.command) ?? "";
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
