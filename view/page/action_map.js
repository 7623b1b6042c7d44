// What the teams did with the ball, as drawings on the field: the paths of possession chains, and where the ball
// was lost. Positions are turned as if the teams had always played at their current ends.

const kLoss_mm = 350;  // radius of a loss; where several overlap, the colour is stronger

// `drawing` is the element that will contain the new one.
function svgElement(drawing, name, attributes) {
  const element = document.createElementNS(drawing.namespaceURI, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}

class ActionMap {
  constructor(chains, signals) {
    this.chains = chains;
    this.signals = signals;
    this.paths = document.getElementById("paths");
    this.losses = document.getElementById("losses");
  }

  // Draws the actions of the chains that match the filter.
  update() {
    const actions = this.chains.matchingActions();
    this.paths.replaceChildren(...actions.filter(({kind}) => kind !== "foul").map((one) => this.line(one)));
    this.losses.replaceChildren(...actions.filter(({kind}) => kind === "loss").map((one) => this.loss(one)));
  }

  positionNow([x, y], time_s) {
    const turn = turnAt(this.signals, time_s);
    return [turn * x, turn * y];
  }

  line(action) {
    const {kind, side, start_s, end_s, from_mm, to_mm} = action;
    const [x1, y1] = this.positionNow(from_mm, start_s);
    const [x2, y2] = this.positionNow(to_mm, end_s);
    return svgElement(this.paths, "line", {"data-kind": kind, x1, y1, x2, y2, stroke: kColors.sides[side]});
  }

  loss({side, end_s, to_mm}) {
    const [cx, cy] = this.positionNow(to_mm, end_s);
    return svgElement(this.losses, "circle", {cx, cy, r: kLoss_mm, fill: kColors.sides[side]});
  }

  // `layers` says which of both drawings are on; the rest is as in ShotMap.
  show(layers, yellowEnd, pixel_mm) {
    const scale = (yellowEnd === 1 ? -1 : 1) / pixel_mm;
    for (const [drawing, isOn] of [[this.paths, layers.paths], [this.losses, layers.losses]]) {
      drawing.style.display = isOn ? "" : "none";
      drawing.setAttribute("transform", `scale(${scale} ${-scale})`);
    }
  }
}
