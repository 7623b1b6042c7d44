// A recording that grows while the game goes on.

const kMostLiveFrames = 36000;  // 20 minutes at 30 frames per second
const kDroppedAtOnce = 6000;    // number of the oldest frames dropped if there are too many

class LiveRecording extends Recording {
  constructor(signals) {
    super({frames: 0, robots: [], signals: []}, "");
    this.signals = signals;
    this.allTimes_s = new Float64Array(kMostLiveFrames);
    this.yellowEnds = new Uint8Array(kMostLiveFrames);
    this.ball = this.newTrack({}, ["x", "y", "height"]);
    this.clear();
  }

  newTrack(track, names) {
    for (const name of names) track[name] = new Int16Array(kMostLiveFrames).fill(kNothing);
    return track;
  }

  clear() {
    this.robots.length = 0;
    this.setCount(0);
  }

  setCount(count) {
    this.count = count;
    this.times_s = this.allTimes_s.subarray(0, count);
    this.first_s = count > 0 ? this.times_s[0] : 0;
    this.last_s = count > 0 ? this.times_s[count - 1] : 0;
    this.length_s = this.last_s - this.first_s;
  }

  // Adds the frames of a message (GameRecording::bytes()), whose signals are already known.
  append({frames, robots, bytes}) {
    if (frames === 0) return;
    const unpacker = new Unpacker(bytesOf(bytes));
    const times_s = unpacker.times_s(frames);
    if (this.count + frames > kMostLiveFrames) this.dropOldest();
    const begin = this.count;
    this.allTimes_s.set(times_s, begin);
    this.hide(begin, begin + frames);
    for (const [side, number] of robots) {
      const robot = this.robotOf(side, number);
      for (const name of ["x", "y", "heading"]) robot[name].set(unpacker.column(frames), begin);
    }
    for (const name of ["x", "y", "height"]) this.ball[name].set(unpacker.column(frames), begin);
    times_s.forEach((time_s, i) => { this.yellowEnds[begin + i] = this.yellowEndAt(time_s); });
    this.setCount(begin + frames);
    this.forgetFreed(begin);
  }

  // A robot that is missing in a message was not seen.
  hide(begin, end) {
    for (const robot of this.robots) robot.x.fill(kNothing, begin, end);
  }

  robotOf(side, number) {
    const known = this.robots.find((robot) => robot.side === side && robot.number === number);
    if (known) return known;
    this.robots.push(this.newTrack({side, number}, ["x", "y", "heading"]));
    return this.robots[this.robots.length - 1];
  }

  yellowEndAt(time_s) {
    const signal = this.signals[lastNotAfter(this.signals, time_s + 1e-6, (one) => one.time_s)];
    return signal ? endOfYellow(signal) : 0;
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
