// The possession chains below the timeline, yellow above blue, with a description of one chain.

const kReach_px = 12;  // a pointer this close to a chain points at it

class ChainStrip {
  // Calls `seek(time_s)` when the user picks a chain.
  constructor(chains, timeline, seek) {
    this.chains = chains;
    this.timeline = timeline;
    this.seek = seek;
    this.strip = document.getElementById("chainStrip");
    this.now = document.getElementById("chainNow");
    this.segments = new Map();  // the element of each chain
    this.pointed = null;  // the chain under the pointer
    this.listen();
  }

  listen() {
    this.strip.addEventListener("pointermove", (event) => this.point(this.chainUnder(event)));
    this.strip.addEventListener("pointerleave", () => this.point(null));
    this.strip.addEventListener("click", (event) => {
      const chain = this.chainUnder(event);
      if (chain) this.seek(chain.start_s);
    });
  }

  // Adds new chains and shows which ones match the filter.
  update() {
    const {chains} = this.chains;
    for (const chain of chains.slice(this.segments.size)) this.addSegment(chain);
    const matching = this.chains.matchingChains();
    for (const [chain, segment] of this.segments) segment.classList.toggle("faded", !this.chains.matches(chain));
    setText("chainCount", matching.length === chains.length ? `${chains.length} chains`
                                                            : `${matching.length} of ${chains.length} chains`);
  }

  addSegment(chain) {
    const segment = textElement("span", "chain", "");
    segment.dataset.side = String(chain.side);
    segment.dataset.end = chain.end;
    segment.classList.toggle("withShot", chain.shots > 0);
    this.segments.set(chain, segment);
    this.place(chain, segment);
    this.strip.append(segment);
  }

  place({start_s, end_s}, {style}) {
    const from = this.timeline.shareOf(start_s);
    style.left = `${100 * from}%`;
    style.width = `${100 * (this.timeline.shareOf(end_s) - from)}%`;
  }

  // The matching chain at or close to the pointer, or null.
  chainUnder(event) {
    const time_s = this.timeline.timeUnder(event);
    const reach_s = kReach_px * this.timeline.secondsPerPixel();
    const distance_s = ({start_s, end_s}) => Math.max(start_s - time_s, time_s - end_s, 0);
    let nearest = null;
    for (const chain of this.chains.matchingChains()) {
      if (distance_s(chain) < distance_s(nearest ?? {start_s: time_s + reach_s, end_s: time_s + reach_s})) nearest = chain;
    }
    return nearest;
  }

  point(chain) {
    if (chain === this.pointed) return;
    this.segments.get(this.pointed)?.classList.remove("pointed");
    this.segments.get(chain)?.classList.add("pointed");
    this.pointed = chain;
    this.strip.title = chain ? chainTitle(chain) : "";
    this.describe();
  }

  // Describes the chain under the pointer or else the one in progress.
  describe() {
    const chain = this.pointed ?? this.current;
    this.list(chain);
    setText("chain", chain ? `${minutesAndSeconds(chain.start_s)}  ${chainTitle(chain)}${this.worthOf(chain)}` : "");
    document.getElementById("chain").dataset.side = chain ? String(chain.side) : "";
  }

  // What the chain was worth.
  worthOf(chain) {
    const actions = this.chains.actionsOf(chain);
    return actions.length === 0 ? "" : `, worth ${signedText(actions.reduce((sum, {worth}) => sum + worth, 0))}`;
  }

  // Lists the actions of the chain, if there is one.
  list(chain) {
    if (chain === this.listed) return;
    this.listed = chain;
    const items = chain ? this.chains.actionsOf(chain).map((action) => textElement("li", "", actionTitle(action))) : [];
    document.getElementById("chainActionList").replaceChildren(...items);
  }

  show(time_s) {
    this.now.style.left = `${100 * this.timeline.shareOf(time_s)}%`;
    this.current = this.chains.chainAt(time_s);
    this.describe();
  }
}
