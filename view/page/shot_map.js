// The shots of a simulated game as dots on the field. The area of a dot is proportional to the shot's
// expected goals (xG), down to a smallest size (style.css). Positions are turned as if the teams had
// always played at their current ends.

const kSureGoal_mm = 600;  // diameter of a dot whose xG is 1
const kBeforeShot_s = 1;

// 1 if yellow defended the end at -x at this time, otherwise -1.
function turnAt(signals, time_s) {
  const signal = signals[lastNotAfter(signals, time_s + 1e-6, (one) => one.time_s)];
  return signal && endOfYellow(signal) === 1 ? -1 : 1;
}

class ShotMap {
  // Calls `seek(time_s)` when the user picks a shot.
  constructor(chains, signals, seek) {
    this.chains = chains;
    this.signals = signals;
    this.seek = seek;
    this.map = document.getElementById("shots");
  }

  update() {
    // Small dots are added last, so that large ones do not hide them.
    const shots = this.chains.matchingShots().sort((one, other) => other.xg - one.xg);
    this.map.replaceChildren(...shots.map((shot) => this.dot(shot)));
  }

  dot(shot) {
    const dot = textElement("button", "shot", "");
    dot.type = "button";
    dot.tabIndex = -1;  // keyboard users reach shots through the filter of chains
    dot.classList.toggle("scored", shot.hasScored);
    dot.style.color = kColors.sides[shot.side];
    const [x, y] = shot.position_mm.map((coordinate) => turnAt(this.signals, shot.time_s) * coordinate);
    dot.style.setProperty("--x", x);
    dot.style.setProperty("--y", y);
    dot.style.setProperty("--diameter", kSureGoal_mm * Math.sqrt(shot.xg));
    dot.title = shotTitle(shot);
    dot.setAttribute("aria-label", dot.title);
    dot.addEventListener("click", () => this.seek(shot.time_s - kBeforeShot_s));
    return dot;
  }

  // `yellowEnd` is the end that yellow defends now; the field has `pixel_mm` millimetres per pixel.
  show(isOn, yellowEnd, pixel_mm) {
    this.map.hidden = !isOn;
    this.map.style.setProperty("--mm", `${1 / pixel_mm}px`);
    this.map.style.setProperty("--turn", yellowEnd === 1 ? -1 : 1);
  }
}
