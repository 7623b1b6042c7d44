// Speeds and trails, computed from the frames.

const kSpeedPictures = 3;  // frames before and after; with fewer, vision noise would show
const kTrailPictures = 90;
const kTrailParts = 9;  // opacity levels

// In mm/s; null if unknown.
function velocityAt(recording, track, index) {
  const from = Math.max(0, index - kSpeedPictures);
  const to = Math.min(recording.count - 1, index + kSpeedPictures);
  const passed_s = recording.times_s[to] - recording.times_s[from];
  const isKnown = track.x[from] !== kNothing && track.x[to] !== kNothing && recording.keptEnds(from, to);
  if (!isKnown || passed_s <= 0 || passed_s > 2 * kSpeedPictures * kLongestGap_s) return null;
  const x = (track.x[to] - track.x[from]) / passed_s;
  const y = (track.y[to] - track.y[from]) / passed_s;
  return {x, y, speed: Math.hypot(x, y)};
}

// Whether the object moved by itself between two frames: it was seen in both, and not placed.
function hasRun(recording, track, from, to) {
  if (track.x[from] === kNothing || track.x[to] === kNothing || !recording.keptEnds(from, to)) return false;
  return Math.hypot(track.x[to] - track.x[from], track.y[to] - track.y[from]) <= kFarthestStep_mm;
}

// Adds the track between two frames to the context's path.
function traceWay(context, recording, track, from, to) {
  let isDrawing = false;
  for (let i = Math.max(1, from + 1); i <= to; ++i) {
    const isStep = hasRun(recording, track, i - 1, i);
    if (isStep && !isDrawing) context.moveTo(track.x[i - 1], track.y[i - 1]);
    if (isStep) context.lineTo(track.x[i], track.y[i]);
    isDrawing = isStep;
  }
}
