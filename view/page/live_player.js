// Time control of a live game: it follows the newest frame until the user chooses another time.

const kFollowing_s = 0.15;   // how far behind the newest frame it plays
const kFarBehind_s = 2;      // if it is farther behind, it jumps
const kAlmostLive_s = 0.05;
const kNoLonger_s = 0.002;   // closer than this, it has reached the newest frame

class LivePlayer extends Player {
  constructor(recording, onChange) {
    super(recording, onChange);
    this.isWaiting = true;  // until the recording is complete
    this.follow();
  }

  follow() {
    this.isFollowing = true;
    this.isPlaying = true;
    this.lastTick_ms = null;
    this.onChange();
  }

  toggle() {
    this.isFollowing = false;
    super.toggle();
  }

  seek(time_s) {
    const isLive = time_s >= this.recording.last_s - kAlmostLive_s;
    if (isLive && this.isPlaying) return this.follow();
    this.isFollowing = false;
    super.seek(time_s);
  }

  // Old frames may have been dropped.
  isLost() {
    return this.time_s < this.recording.first_s;
  }

  tick(now_ms) {
    if (this.isWaiting) return;
    if (this.isLost()) this.time_s = this.recording.first_s;
    if (!this.isFollowing) return super.tick(now_ms);
    const passed_s = this.lastTick_ms === null ? 0 : (now_ms - this.lastTick_ms) / 1000;
    this.lastTick_ms = now_ms;
    const behind_s = this.recording.last_s - this.time_s;
    if (behind_s === 0) return;
    const size_s = Math.abs(behind_s);
    const share = size_s > kFarBehind_s || size_s < kNoLonger_s ? 1 : 1 - Math.exp(-passed_s / kFollowing_s);
    this.time_s += behind_s * share;
    this.onChange();
  }
}
