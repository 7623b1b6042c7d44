// A recording that grows while the game goes on.

const kMostLiveFrames = 36000;  // 20 minutes at 30 frames per second
const kDroppedAtOnce = 6000;    // number of the oldest frames dropped if there are too many

class LiveRecording extends Recording {
  constructor(signals) {
    super(signals, kMostLiveFrames);
  }

  clear() {
    this.robots.length = 0;
    this.setCount(0);
  }

  append(part) {
    if (part.frames === 0) return;
    if (this.count + part.frames > kMostLiveFrames) this.dropOldest();
    const begin = this.count;
    this.hide(begin, begin + part.frames);
    super.append(part);
    this.forgetFreed(begin);
  }

  // A robot that is missing in a message was not seen.
  hide(begin, end) {
    for (const robot of this.robots) robot.x.fill(kNothing, begin, end);
  }

  dropOldest() {
    for (const track of [...this.robots, this.ball]) {
      for (const numbers of Object.values(track)) {
        if (numbers instanceof Int16Array) numbers.copyWithin(0, kDroppedAtOnce);
      }
    }
    this.allTimes_s.copyWithin(0, kDroppedAtOnce);
    this.yellowEnds.copyWithin(0, kDroppedAtOnce);
    this.setCount(this.count - kDroppedAtOnce);
    this.forgetFreed(0);
  }

  // Signals cache the frame in which the ball came into play (freedAt()). Forgets those that can still change.
  forgetFreed(fromFrame) {
    for (let i = this.signals.length - 1; i >= 0; --i) {
      const signal = this.signals[i];
      if (signal.freedAt < fromFrame) return;
      if (signal.freedAt !== undefined) signal.freedAt = undefined;
    }
  }
}
