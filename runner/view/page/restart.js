// What the rules require at restarts: who must keep away from the ball, and until when.

const kInPlay_mm = 50;  // the ball is in play once it has moved this far (Laws 13)
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

// The first frame with the ball in play after the signal; cached in the signal.
function freedAt(recording, signal) {
  if (signal.freedAt !== undefined) return signal.freedAt;
  const {x, y} = recording.ball;
  const begin = recording.indexAt(signal.time_s);
  let i = begin;
  while (i < recording.count && Math.hypot(x[i] - x[begin], y[i] - y[begin]) <= kInPlay_mm) ++i;
  signal.freedAt = i;
  return i;
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
