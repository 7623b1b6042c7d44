// Lists that grow while the game goes on.

function isSameHighlight(one, other) {
  return one !== undefined && one.time_s === other.time_s && one.title === other.title && one.reason === other.reason;
}

// How many highlights at the beginning of the two lists are the same.
function sameUntil(one, other) {
  let same = 0;
  while (same < other.length && isSameHighlight(one[same], other[same])) ++same;
  return same;
}

class LiveEventList extends EventList {
  constructor(seek) {
    super([], seek);
    this.seek = seek;
    this.list.replaceChildren();
  }

  update(highlights) {
    const same = sameUntil(this.highlights, highlights);
    while (this.list.children.length > same) this.list.lastChild.remove();
    for (const highlight of highlights.slice(same)) this.list.append(highlightItem(highlight, this.seek));
    this.highlights = highlights;
    this.current = -2;  // unlike any index: the next show() marks the current event
  }
}

class LiveTimeline extends Timeline {
  constructor(recording, seek) {
    super(recording, [], seek);
    this.marks = document.getElementById("marks");
    this.highlights = [];
  }

  update(highlights) {
    const same = sameUntil(this.highlights, highlights);
    while (this.marks.children.length > same) this.marks.lastChild.remove();
    this.addMarks(highlights.slice(same));
    this.highlights = highlights;
    this.moveMarks();
  }

  // The range changes, so all marks move; those before its beginning disappear.
  moveMarks() {
    this.slider.setAttribute("aria-valuemax", String(Math.round(this.recording.last_s)));
    this.highlights.forEach(({time_s}, i) => {
      const {style} = this.marks.children[i];
      style.left = `${100 * this.shareOf(time_s)}%`;
      style.display = time_s < this.recording.first_s ? "none" : "";
    });
  }
}

class LiveChainStrip extends ChainStrip {
  // The oldest chains may have been dropped.
  update() {
    const kept = new Set(this.chains.chains);
    for (const [chain, segment] of this.segments) {
      if (kept.has(chain)) continue;
      segment.remove();
      this.segments.delete(chain);
    }
    if (!kept.has(this.pointed)) this.point(null);
    super.update();
    this.moveSegments();
  }

  // The range changes, so all segments move; those before its beginning disappear.
  moveSegments() {
    for (const [chain, segment] of this.segments) {
      this.place(chain, segment);
      segment.style.display = chain.end_s < this.timeline.recording.first_s ? "none" : "";
    }
  }
}
