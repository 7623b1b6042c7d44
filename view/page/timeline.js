// The timeline: a slider with a mark for each highlight.

class Timeline {
  // Calls `seek(time_s)` when the user picks a time.
  constructor(recording, highlights, seek) {
    this.recording = recording;
    this.seek = seek;
    this.slider = document.getElementById("timeline");
    this.played = document.getElementById("played");
    this.knob = document.getElementById("knob");
    this.slider.setAttribute("aria-valuemax", String(Math.round(recording.last_s)));
    this.addMarks(highlights);
    this.listen();
  }

  shareOf(time_s) {
    const {first_s, length_s} = this.recording;
    return length_s > 0 ? Math.min(Math.max((time_s - first_s) / length_s, 0), 1) : 0;
  }

  addMarks(highlights) {
    const marks = document.getElementById("marks");
    for (const highlight of highlights) {
      const mark = document.createElement("button");
      mark.type = "button";
      mark.tabIndex = -1;  // keyboard users reach events through the list
      mark.className = `mark ${highlight.kind}`;
      mark.classList.toggle("missed", highlight.isMissed === true);
      mark.classList.toggle("disagreement", highlight.isDisagreement === true);
      mark.dataset.side = highlight.side ?? "";
      mark.dataset.color = highlight.color ?? "";
      mark.style.left = `${100 * this.shareOf(highlight.time_s)}%`;
      mark.title = `${minutesAndSeconds(highlight.time_s)}  ${highlight.title}`;
      mark.setAttribute("aria-label", mark.title);
      mark.addEventListener("click", () => this.seek(highlight.time_s));
      marks.append(mark);
    }
  }

  listen() {
    const follow = (event) => this.seek(this.timeUnder(event));
    this.slider.addEventListener("pointerdown", (event) => {
      if (event.target.classList.contains("mark")) return;
      this.slider.setPointerCapture(event.pointerId);
      follow(event);
    });
    this.slider.addEventListener("pointermove", (event) => {
      if (this.slider.hasPointerCapture(event.pointerId)) follow(event);
    });
  }

  timeUnder(event) {
    const {left} = this.slider.getBoundingClientRect();
    return this.recording.first_s + (event.clientX - left) * this.secondsPerPixel();
  }

  secondsPerPixel() {
    return this.recording.length_s / this.slider.getBoundingClientRect().width;
  }

  show(time_s) {
    const percent = `${100 * this.shareOf(time_s)}%`;
    this.played.style.width = percent;
    this.knob.style.left = percent;
    this.slider.setAttribute("aria-valuenow", String(Math.round(time_s)));
    this.slider.setAttribute("aria-valuetext", minutesAndSeconds(time_s));
  }
}
