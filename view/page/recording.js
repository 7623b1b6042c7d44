// Unpacks the recorded game (view/game_recording.hpp) and interpolates between its frames.
"use strict";

const kNothing = -32768;
const kWholeNumberFollows = 0x80;
const kTicksPerSecond = 10000;
// Do not interpolate across a longer gap between frames.
const kLongestGap_s = 0.12;
const kFarthestStep_mm = 400;

function bytesOf(base64) {
  const letters = atob(base64.trim());
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

// Decodes the output of PackedColumn and GameRecording, from the first byte to the last.
class Unpacker {
  constructor(bytes) {
    this.bytes = bytes;
    this.place = 0;
  }

  times_s(count) {
    const view = new DataView(this.bytes.buffer, this.place);
    const times = new Float64Array(count);
    for (let i = 0; i < count; ++i) times[i] = view.getUint32(4 * i, true) / kTicksPerSecond;
    this.place += 4 * count;
    return times;
  }

  column(count) {
    const {bytes} = this;
    const numbers = new Int16Array(count);
    let place = this.place;
    let last = kNothing;
    for (let i = 0; i < count; ++i) {
      const byte = bytes[place++];
      if (byte === kWholeNumberFollows) {
        last = bytes[place] | (bytes[place + 1] << 24 >> 16);
        place += 2;
      } else {
        last += byte << 24 >> 24;
      }
      numbers[i] = last;
    }
    this.place = place;
    return numbers;
  }
}

function mix(from, to, share) {
  return from + (to - from) * share;
}

// Interpolates between angles along the shorter arc, in tenths of a degree.
function mixAngles(from, to, share) {
  const way = ((to - from + 5400) % 3600) - 1800;
  return from + way * share;
}

class Recording {
  constructor(signals, mostFrames) {
    this.signals = signals;
    this.mostFrames = mostFrames;
    this.allTimes_s = new Float64Array(mostFrames);
    // The end that yellow defends in each frame: 0 is at -x, 1 at +x.
    this.yellowEnds = new Uint8Array(mostFrames);
    this.robots = [];
    this.ball = this.newTrack({}, ["x", "y", "height"]);
    this.setCount(0);
  }

  newTrack(track, names) {
    for (const name of names) track[name] = new Int16Array(this.mostFrames).fill(kNothing);
    return track;
  }

  setCount(count) {
    this.count = count;
    this.times_s = this.allTimes_s.subarray(0, count);
    this.first_s = count > 0 ? this.times_s[0] : 0;
    this.last_s = count > 0 ? this.times_s[count - 1] : 0;
    this.length_s = this.last_s - this.first_s;
  }

  // Adds the frames of a part of the game (GameRecording::bytes()), whose signals are already known.
  append({frames, robots, bytes}) {
    const unpacker = new Unpacker(bytesOf(bytes));
    const times_s = unpacker.times_s(frames);
    const begin = this.count;
    this.allTimes_s.set(times_s, begin);
    for (const [side, number] of robots) {
      const robot = this.robotOf(side, number);
      for (const name of ["x", "y", "heading"]) robot[name].set(unpacker.column(frames), begin);
    }
    for (const name of ["x", "y", "height"]) this.ball[name].set(unpacker.column(frames), begin);
    times_s.forEach((time_s, i) => { this.yellowEnds[begin + i] = this.yellowEndAt(time_s); });
    this.setCount(begin + frames);
  }

  robotOf(side, number) {
    const known = this.robots.find((robot) => robot.side === side && robot.number === number);
    if (known) return known;
    this.robots.push(this.newTrack({side, number}, ["x", "y", "heading"]));
    return this.robots[this.robots.length - 1];
  }

  yellowEndAt(time_s) {
    const signal = this.signals[lastNotAfter(this.signals, time_s + 1 / kTicksPerSecond, (one) => one.time_s)];
    return signal ? endOfYellow(signal) : 0;
  }

  // Whether the teams kept their ends from one frame to the next.
  keptEnds(from, to) {
    return this.yellowEnds[from] === this.yellowEnds[to];
  }

  // Index of the last frame not later than this time, with a tolerance of one tick.
  indexAt(time_s) {
    return Math.max(0, lastNotAfter(this.times_s, time_s + 1 / kTicksPerSecond, (frame_s) => frame_s));
  }

  // Everything on the field at this time, interpolated between the frames before and after it.
  sceneAt(time_s) {
    const index = this.indexAt(time_s);
    const next = Math.min(index + 1, this.count - 1);
    const gap_s = this.times_s[next] - this.times_s[index];
    const passed_s = Math.max(0, time_s - this.times_s[index]);
    const isShort = gap_s > 0 && gap_s <= kLongestGap_s && this.keptEnds(index, next);
    const share = isShort ? Math.min(passed_s / gap_s, 1) : 0;
    const between = {index, next, share};
    return {
      index,
      time_s,
      yellowEnd: this.yellowEnds[index],
      robots: this.robots.map((robot) => robotBetween(robot, between)).filter(Boolean),
      ball: ballBetween(this.ball, between),
    };
  }
}

// Index of the last element of the sorted `list` whose time is not after `time_s`, or -1.
function lastNotAfter(list, time_s, timeOf) {
  let low = 0;
  let high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (timeOf(list[middle]) <= time_s) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

// Interpolation weight: 0 if the object moved so far in one frame that it must have been placed.
function shareFor(track, {index, next, share}) {
  if (track.x[next] === kNothing) return 0;
  const step = Math.hypot(track.x[next] - track.x[index], track.y[next] - track.y[index]);
  return step > kFarthestStep_mm ? 0 : share;
}

function robotBetween(robot, between) {
  const {index, next} = between;
  if (robot.x[index] === kNothing) return null;
  const share = shareFor(robot, between);
  const heading = mixAngles(robot.heading[index], robot.heading[next], share);
  return {
    side: robot.side,
    number: robot.number,
    x: mix(robot.x[index], robot.x[next], share),
    y: mix(robot.y[index], robot.y[next], share),
    heading_rad: heading * Math.PI / 1800,
  };
}

function ballBetween(ball, between) {
  const {index, next} = between;
  if (ball.x[index] === kNothing) return null;
  const share = shareFor(ball, between);
  const isHeightKnown = ball.height[index] !== kNothing && ball.height[next] !== kNothing;
  return {
    x: mix(ball.x[index], ball.x[next], share),
    y: mix(ball.y[index], ball.y[next], share),
    height: isHeightKnown ? mix(ball.height[index], ball.height[next], share) : null,
  };
}
