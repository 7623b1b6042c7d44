// The rules at restarts: who must keep away from the ball, and until when. Also whether the ball is in play.

const kInPlay_mm = 50;  // the ball is in play once it has moved this far (Laws 13)
const kOutsideFrames = 3;  // consecutive; fewer may be a false detection
const kRestarts = ["DIRECT_FREE", "INDIRECT_FREE", "PREPARE_KICKOFF", "NORMAL_START"];
const kRunning = ["NORMAL_START", "FORCE_START", "DIRECT_FREE", "INDIRECT_FREE"];

function isRunning(signal) {
  return kRunning.includes(kindOfCommand(signal.command));
}

// The side taking the current restart, from the command or the one before it, or null.
function takerOf(signals, index) {
  const side = sideOfCommand(signals[index].command);
  if (side !== null || signals[index].command !== "NORMAL_START" || index === 0) return side;
  return sideOfCommand(signals[index - 1].command);
}

// The first frame with the ball in play after the signal; cached in the signal. A ball that is not
// seen has not moved.
function freedAt(recording, signal) {
  if (signal.freedAt !== undefined) return signal.freedAt;
  const {x, y} = recording.ball;
  let begin = recording.indexAt(signal.time_s);
  while (begin < recording.count && x[begin] === kNothing) ++begin;
  const isThere = (i) => x[i] === kNothing || Math.hypot(x[i] - x[begin], y[i] - y[begin]) <= kInPlay_mm;
  let i = begin;
  while (i < recording.count && isThere(i)) ++i;
  signal.freedAt = i;
  return i;
}

// Whether the ball was wholly outside the field in some frames from `begin` to `end`.
function hasLeftField(recording, {field, shapes}, begin, end) {
  const {x, y} = recording.ball;
  const far_mm = {x: field.halfLength_mm + shapes.ballRadius_mm, y: field.halfWidth_mm + shapes.ballRadius_mm};
  let outside = 0;
  for (let i = begin; i <= end && outside < kOutsideFrames; ++i) {
    if (x[i] === kNothing) continue;
    outside = Math.abs(x[i]) > far_mm.x || Math.abs(y[i]) > far_mm.y ? outside + 1 : 0;
  }
  return outside >= kOutsideFrames;
}

// "before" if the restart has not been taken or the game is stopped, "in" during play, or "out" if the ball
// has left the field and no command has followed.
function playAt(recording, game, signal, frame) {
  if (!signal || !isRunning(signal)) return "before";
  const isForced = kindOfCommand(signal.command) === "FORCE_START";
  const begin = isForced ? recording.indexAt(signal.time_s) : freedAt(recording, signal);
  if (frame < begin) return "before";
  return hasLeftField(recording, game, begin, frame) ? "out" : "in";
}

// The sides that must now keep away from the ball; empty while play is on.
function sidesKeptAway(recording, signals, index, frame) {
  const signal = signals[index];
  if (!signal) return [];
  const kind = kindOfCommand(signal.command);
  if (kind === "STOP") return [0, 1];
  if (!kRestarts.includes(kind)) return [];
  const taker = takerOf(signals, index);
  const isFreed = kind !== "PREPARE_KICKOFF" && frame >= freedAt(recording, signal);
  return taker === null || isFreed ? [] : [1 - taker];
}

// The robot of these sides nearest to the ball, measured to its hull, or null.
function nearestToBall(scene, sides, robotRadius_mm) {
  let nearest = null;
  for (const robot of scene.robots) {
    if (!scene.ball || !sides.includes(robot.side)) continue;
    const distance = Math.hypot(robot.x - scene.ball.x, robot.y - scene.ball.y) - robotRadius_mm;
    if (!nearest || distance < nearest.distance) nearest = {robot, distance: Math.max(0, distance)};
  }
  return nearest;
}
