// The field with its lines, as given in the data. It is redrawn only when the window size changes.

const kColors = {
  carpet: "#1c5b40",
  runOff: "#174c36",
  wall: "#0b2419",
  line: "rgba(255, 255, 255, 0.88)",
  sides: ["#ffd43b", "#4a9dff"],
  onSides: ["#1d1a05", "#04152b"],
  ball: "#ff7b1c",
  watched: "rgba(255, 255, 255, 0.7)",
  broken: "#ff6b6b",
  mark: "#ffffff",  // drawings on the carpet: the ball's target, speeds, calls
};

// Dark fields would waste ink on paper.
const kPaperColors = {
  carpet: "#ffffff",
  runOff: "#f2f2f2",
  wall: "#999999",
  line: "#555555",
  watched: "#777777",
  mark: "#000000",
};
const kScreenColors = {...kColors};

function drawOnPaper(isPaper) {
  Object.assign(kColors, isPaper ? kPaperColors : kScreenColors);
}

function tracePath(context, points) {
  context.beginPath();
  points.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
}

function strokeOutline(context, {lines, arcs}) {
  for (const line of lines) {
    tracePath(context, line);
    context.stroke();
  }
  for (const {centre_mm, radius_mm, from_rad, to_rad} of arcs) {
    context.beginPath();
    context.arc(centre_mm[0], centre_mm[1], radius_mm, from_rad, to_rad);
    context.stroke();
  }
}

function fillDisc(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}

// Each goal has the colour of the team that defends it.
function drawGoals(context, field, thin, yellowEnd) {
  context.lineWidth = Math.max(20, 2 * thin);
  field.goals.forEach((walls, end) => {
    context.strokeStyle = kColors.sides[end === yellowEnd ? 0 : 1];
    tracePath(context, walls);
    context.stroke();
  });
}

// Draws in millimetres with y upwards. `thin` is the size of a pixel in millimetres, and `yellowEnd` is the
// end that yellow defends.
function drawField(context, field, thin, yellowEnd) {
  const {halfLength_mm: x, halfWidth_mm: y} = field;
  const [wallX, wallY] = field.wall_mm;
  context.strokeStyle = kColors.wall;
  context.lineWidth = Math.max(20, 2 * thin);
  context.strokeRect(-wallX, -wallY, 2 * wallX, 2 * wallY);
  context.fillStyle = kColors.carpet;
  context.fillRect(-x, -y, 2 * x, 2 * y);
  context.strokeStyle = kColors.line;
  context.fillStyle = kColors.line;
  context.lineWidth = Math.max(field.lineWidth_mm, 1.2 * thin);
  strokeOutline(context, field.marks);
  for (const [markX, markY] of field.penaltyMarks) fillDisc(context, markX, markY, Math.max(20, 1.8 * thin));
  drawGoals(context, field, thin, yellowEnd);
}
