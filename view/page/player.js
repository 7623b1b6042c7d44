// Time control: playing, speed and steps. It does not depend on the page.

const kSpeeds = [0.25, 0.5, 1, 2, 4, 8, 16];
const kLongestTick_s = 0.25;  // longest step, so a hidden page does not jump

class Player {
  // Calls `onChange()` whenever the time, the speed or the play state has changed.
  constructor(recording, onChange) {
    this.recording = recording;
    this.onChange = onChange;
    this.time_s = recording.first_s;
    this.speed = 1;
    this.isPlaying = false;
    this.lastTick_ms = null;
  }

  isAtEnd() {
    return this.time_s >= this.recording.last_s;
  }

  toggle() {
    if (!this.isPlaying && this.isAtEnd()) this.time_s = this.recording.first_s;
    this.isPlaying = !this.isPlaying;
    this.lastTick_ms = null;
    this.onChange();
  }

  pause() {
    if (this.isPlaying) this.toggle();
  }

  seek(time_s) {
    const {first_s, last_s} = this.recording;
    this.time_s = Math.min(Math.max(time_s, first_s), last_s);
    this.onChange();
  }

  // Pauses and moves by this many frames.
  step(frames) {
    this.pause();
    const {times_s, count} = this.recording;
    const index = this.recording.indexAt(this.time_s) + frames;
    this.seek(times_s[Math.min(Math.max(index, 0), count - 1)]);
  }

  changeSpeed(steps) {
    const place = kSpeeds.indexOf(this.speed) + steps;
    this.speed = kSpeeds[Math.min(Math.max(place, 0), kSpeeds.length - 1)];
    this.onChange();
  }

  // `now_ms` is the browser's clock.
  tick(now_ms) {
    if (!this.isPlaying) return;
    const passed_s = this.lastTick_ms === null ? 0 : (now_ms - this.lastTick_ms) / 1000;
    this.lastTick_ms = now_ms;
    this.seek(this.time_s + this.speed * Math.min(passed_s, kLongestTick_s));
    if (this.isAtEnd()) this.pause();
  }
}
