// The table of shoot-out kicks: one row per side, one button per kick.

const kMostKicksInLine = 16;  // of both sides; a longer list moves below the names

function kickButton(kick, seek) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "kick";
  button.dataset.scored = String(kick.scored);
  button.dataset.side = String(kick.side);
  button.title = kickTitle(kick);
  button.setAttribute("aria-label", button.title);
  button.textContent = kick.scored ? "\u25cf" : "\u2715";
  button.addEventListener("click", () => seek(kick.time_s));
  return button;
}

class Shootout {
  constructor(kicks, names, seek) {
    this.kicks = kicks;
    if (kicks.length === 0) return;
    const box = document.getElementById("shootout");
    box.hidden = false;
    box.classList.toggle("many", kicks.length > kMostKicksInLine);
    for (const side of [0, 1]) {
      const own = kicks.filter((kick) => kick.side === side);
      const buttons = document.createElement("span");
      buttons.className = "kicks";
      buttons.append(...own.map((kick) => kickButton(kick, seek)));
      const goals = own.filter((kick) => kick.scored).length;
      const row = textElement("div", "kickRow", "");
      row.append(textElement("span", "kicker", names[side]), buttons,
                 textElement("span", "kickGoals", `${goals} of ${own.length}`));
      box.append(row);
    }
  }

  // Goals of both sides in the shoot-out so far; null before the first kick.
  standingAt(time_s) {
    const index = lastNotAfter(this.kicks, time_s + 1e-6, (kick) => kick.time_s);
    return index < 0 ? null : this.kicks[index].standing;
  }
}
