// Heat map of the ball's positions while it rolled during play. Positions are turned as if yellow had always
// defended the end at -x.

const kCell_mm = 150;
const kHottestShare = 0.99;  // quantile of the cells; hotter ones look the same
const kRolls_mm = 3;         // minimum per frame, so that a ball waiting for its kick does not count

function isRolling(recording, i) {
  const {ball} = recording;
  if (i === 0 || !hasRun(recording, ball, i - 1, i)) return false;
  return Math.hypot(ball.x[i] - ball.x[i - 1], ball.y[i] - ball.y[i - 1]) >= kRolls_mm;
}

function countBall(recording, signals, columns, rows, cellOf) {
  const counts = new Float32Array(columns * rows);
  let index = -1;
  for (let i = 0; i < recording.count; ++i) {
    while (index + 1 < signals.length && signals[index + 1].time_s <= recording.times_s[i]) ++index;
    if (index < 0 || !isRunning(signals[index]) || !isRolling(recording, i)) continue;
    const sign = recording.yellowEnds[i] === 0 ? 1 : -1;
    const cell = cellOf(sign * recording.ball.x[i], sign * recording.ball.y[i]);
    if (cell >= 0) ++counts[cell];
  }
  return counts;
}

// Blurs along rows, then columns: each cell becomes the mean of itself (weighted twice) and its two
// neighbours.
function blurred(counts, columns, rows) {
  const along = (values, step, placeOf, length) => values.map((value, i) => {
    const before = placeOf(i) > 0 ? values[i - step] : value;
    const after = placeOf(i) < length - 1 ? values[i + step] : value;
    return (before + 2 * value + after) / 4;
  });
  const inRows = along(counts, 1, (i) => i % columns, columns);
  return along(inRows, columns, (i) => Math.floor(i / columns), rows);
}

// From transparent through yellow to red.
function paintHeat(counts, pixels) {
  const sorted = [...counts].sort((a, b) => a - b);
  const hottest = Math.max(sorted[Math.floor((sorted.length - 1) * kHottestShare)], 1);
  counts.forEach((count, i) => {
    const heat = Math.min(1, count / hottest);
    pixels.set([255, 225 - 165 * heat, 70 - 30 * heat, 205 * heat ** 1.4], 4 * i);
  });
}

// An image of the whole carpet, one pixel per cell.
function heatImage(recording, signals, {halfLength_mm, halfWidth_mm}) {
  const columns = Math.ceil(2 * halfLength_mm / kCell_mm);
  const rows = Math.ceil(2 * halfWidth_mm / kCell_mm);
  const cellOf = (x, y) => {
    const column = Math.floor((x + halfLength_mm) / kCell_mm);
    const row = Math.floor((halfWidth_mm - y) / kCell_mm);
    return column < 0 || column >= columns || row < 0 || row >= rows ? -1 : row * columns + column;
  };
  const canvas = document.createElement("canvas");
  canvas.width = columns;
  canvas.height = rows;
  const context = canvas.getContext("2d");
  const image = context.createImageData(columns, rows);
  const counts = countBall(recording, signals, columns, rows, cellOf);
  paintHeat(blurred(blurred(counts, columns, rows), columns, rows), image.data);
  context.putImageData(image, 0, 0);
  return canvas;
}
