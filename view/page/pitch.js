// The canvas: field, robots, ball and overlays.

const kSmallestRobot_px = 7.5;
const kSmallestBall_px = 4.4;
const kSlowest_mmps = 150;  // slower speeds are not shown
const kAhead_s = 0.3;       // how far ahead speed arrows point
const kFlying_mm = 30;
const kPulse_s = 3;

class Pitch {
  constructor(canvas, game, recording) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d", {alpha: false});
    this.field = game.field;
    this.shapes = game.shapes;
    this.signals = game.signals;
    this.recording = recording;
    this.still = document.createElement("canvas");  // the static field
    this.yellowEnd = 0;  // the end that yellow defends in it
    this.heat = null;  // computed on first use
  }

  // Fits the field into the canvas area on the page.
  resize() {
    const {clientWidth, clientHeight} = this.canvas;
    const ratio = window.devicePixelRatio || 1;
    const goalDepth_mm = Math.abs(this.field.goals[0][1][0]) - this.field.halfLength_mm;
    const margin_mm = Math.max(goalDepth_mm + 60, 300);
    const x_mm = Math.min(this.field.wall_mm[0], this.field.halfLength_mm + margin_mm);
    const y_mm = Math.min(this.field.wall_mm[1], this.field.halfWidth_mm + margin_mm);
    for (const canvas of [this.canvas, this.still]) {
      canvas.width = Math.max(1, Math.round(clientWidth * ratio));
      canvas.height = Math.max(1, Math.round(clientHeight * ratio));
    }
    this.scale = Math.min(this.canvas.width / (2 * x_mm), this.canvas.height / (2 * y_mm));
    this.pixel_mm = ratio / this.scale;  // millimetres per pixel of the page
    this.drawStill();
  }

  // From here on, lengths are in millimetres and y points upwards.
  useField(context) {
    context.setTransform(this.scale, 0, 0, -this.scale, this.canvas.width / 2, this.canvas.height / 2);
  }

  drawStill() {
    const context = this.still.getContext("2d", {alpha: false});
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = kColors.runOff;
    context.fillRect(0, 0, this.still.width, this.still.height);
    this.useField(context);
    drawField(context, this.field, this.pixel_mm, this.yellowEnd);
  }

  changeEnds(yellowEnd) {
    this.yellowEnd = yellowEnd;
    this.drawStill();
  }

  // `layers` maps the name of each layer to whether it is on; `highlight` is the latest call, if any.
  draw(scene, signalIndex, layers, highlight) {
    const {context} = this;
    if (scene.yellowEnd !== this.yellowEnd) this.changeEnds(scene.yellowEnd);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.still, 0, 0);
    this.useField(context);
    context.lineJoin = "round";
    if (layers.heat) this.drawHeat();
    if (layers.distances) this.drawDistances(scene, signalIndex);
    if (layers.trails) this.drawTrails(scene);
    this.drawPosition(scene, highlight);
    for (const robot of scene.robots) this.drawRobot(robot);
    if (scene.ball) this.drawBall(scene.ball);
    if (layers.speeds) this.drawSpeeds(scene);
  }

  robotRadius() {
    return Math.max(this.shapes.robotRadius_mm, kSmallestRobot_px * this.pixel_mm);
  }

  drawRobot({side, number, x, y, heading_rad}) {
    const {context} = this;
    const radius = this.robotRadius();
    const half_rad = Math.acos(this.shapes.robotFront_mm / this.shapes.robotRadius_mm);
    context.fillStyle = kColors.sides[side];
    context.strokeStyle = "rgba(0, 0, 0, 0.55)";
    context.lineWidth = 1.2 * this.pixel_mm;
    context.beginPath();
    context.arc(x, y, radius, heading_rad + half_rad, heading_rad - half_rad + 2 * Math.PI);
    context.closePath();
    context.fill();
    context.stroke();
    this.drawFront(x, y, heading_rad, radius, half_rad);
    this.write(String(number), x, y, {size_mm: 1.25 * radius, color: kColors.onSides[side], isBold: true});
  }

  // Highlights the flat front of the robot.
  drawFront(x, y, heading_rad, radius, half_rad) {
    const {context} = this;
    context.strokeStyle = "#ffffff";
    context.lineWidth = Math.max(14, 2 * this.pixel_mm);
    tracePath(context, [heading_rad - half_rad, heading_rad + half_rad].map(
      (angle) => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)]));
    context.stroke();
  }

  drawBall({x, y, height}) {
    const {context} = this;
    const radius = Math.max(this.shapes.ballRadius_mm, kSmallestBall_px * this.pixel_mm);
    const isFlying = height !== null && height > kFlying_mm;
    if (isFlying) this.drawHeight(x, y, height, radius);
    context.fillStyle = kColors.ball;
    context.strokeStyle = "#ffffff";
    context.lineWidth = 1.3 * this.pixel_mm;
    fillDisc(context, x, y, radius * (isFlying ? 1 + Math.min(height / 1000, 1) : 1));
    context.stroke();
  }

  // A ring that grows with the height, and the height next to it.
  drawHeight(x, y, height, radius) {
    const {context} = this;
    const ring = radius + 0.25 * height + 5 * this.pixel_mm;
    context.strokeStyle = kColors.mark;
    context.lineWidth = 1.2 * this.pixel_mm;
    context.beginPath();
    context.arc(x, y, ring, 0, 2 * Math.PI);
    context.stroke();
    this.label(`${(height / 1000).toFixed(2)} m high`, x, y + ring + 9 * this.pixel_mm);
  }

  drawTrails(scene) {
    for (const robot of this.recording.robots) {
      this.drawTrail(robot, scene.index, kColors.sides[robot.side], 2, 0.4);
    }
    this.drawTrail(this.recording.ball, scene.index, kColors.ball, 3, 0.95);
  }

  // The trail, which fades with age.
  drawTrail(track, index, color, width_px, strongest) {
    const {context} = this;
    const length = kTrailPictures / kTrailParts;
    context.strokeStyle = color;
    context.lineWidth = width_px * this.pixel_mm;
    for (let part = 0; part < kTrailParts; ++part) {
      context.globalAlpha = strongest * (1 - part / kTrailParts);
      context.beginPath();
      traceWay(context, this.recording, track, index - (part + 1) * length, index - part * length);
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  drawSpeeds(scene) {
    const {recording} = this;
    for (const robot of recording.robots) {
      this.drawSpeed(robot, velocityAt(recording, robot, scene.index), scene.index, this.robotRadius());
    }
    this.drawSpeed(recording.ball, velocityAt(recording, recording.ball, scene.index), scene.index,
                   this.robotRadius() / 2);
  }

  drawSpeed(track, velocity, index, clearance) {
    if (!velocity || velocity.speed < kSlowest_mmps) return;
    const {context} = this;
    const [x, y] = [track.x[index], track.y[index]];
    const [alongX, alongY] = [velocity.x / velocity.speed, velocity.y / velocity.speed];
    const length = clearance + velocity.speed * kAhead_s;
    context.strokeStyle = kColors.mark;
    context.lineWidth = 1.6 * this.pixel_mm;
    tracePath(context, [[x + alongX * clearance, y + alongY * clearance], [x + alongX * length, y + alongY * length]]);
    context.stroke();
    this.label((velocity.speed / 1000).toFixed(1), x, y - clearance - 9 * this.pixel_mm);
  }

  drawDistances(scene, signalIndex) {
    const sides = sidesKeptAway(this.recording, this.signals, signalIndex, scene.index);
    const target = this.signals[signalIndex]?.target_mm;
    if (target) this.drawTarget(target);
    if (sides.length === 0) return;
    const {context} = this;
    context.strokeStyle = kColors.watched;
    context.lineWidth = 1.3 * this.pixel_mm;
    context.setLineDash([6 * this.pixel_mm, 5 * this.pixel_mm]);
    for (const outline of this.field.nearAreas) strokeOutline(context, outline);
    if (scene.ball) this.drawRing(scene.ball);
    context.setLineDash([]);
    this.drawNearest(scene, sides);
  }

  drawRing({x, y}) {
    this.context.beginPath();
    this.context.arc(x, y, this.field.toBall_mm, 0, 2 * Math.PI);
    this.context.stroke();
  }

  drawNearest(scene, sides) {
    const nearest = nearestToBall(scene, sides, this.shapes.robotRadius_mm);
    if (!nearest || nearest.distance > 2 * this.field.toBall_mm) return;
    const {context} = this;
    const {robot, distance} = nearest;
    context.strokeStyle = distance < this.field.toBall_mm ? kColors.broken : kColors.watched;
    tracePath(context, [[scene.ball.x, scene.ball.y], [robot.x, robot.y]]);
    context.stroke();
    this.label(`${Math.round(distance)} mm`, (scene.ball.x + robot.x) / 2, (scene.ball.y + robot.y) / 2);
  }

  // The target of ball placement.
  drawTarget([x, y]) {
    const {context} = this;
    const arm = 7 * this.pixel_mm;
    context.strokeStyle = kColors.mark;
    context.lineWidth = 1.6 * this.pixel_mm;
    for (const sign of [-1, 1]) {
      tracePath(context, [[x - arm, y - sign * arm], [x + arm, y + sign * arm]]);
      context.stroke();
    }
  }

  // Position of the referee's latest call.
  drawPosition(scene, highlight) {
    const age_s = highlight ? scene.time_s - highlight.time_s : kPulse_s;
    if (!highlight?.position_m || age_s >= kPulse_s) return;
    const {context} = this;
    const [x, y] = highlight.position_m.map((metres) => 1000 * metres);
    context.globalAlpha = 1 - age_s / kPulse_s;
    context.strokeStyle = kColors.mark;
    context.lineWidth = 2.5 * this.pixel_mm;
    context.beginPath();
    context.arc(x, y, this.robotRadius() * (1 + age_s), 0, 2 * Math.PI);
    context.stroke();
    context.globalAlpha = 1;
  }

  drawHeat() {
    this.heat ??= heatImage(this.recording, this.signals, this.field);
    const {context} = this;
    const {halfLength_mm: x, halfWidth_mm: y} = this.field;
    context.save();
    context.scale(1, -1);
    if (this.yellowEnd === 1) context.rotate(Math.PI);
    context.imageSmoothingQuality = "high";
    context.drawImage(this.heat, -x, -y, 2 * x, 2 * y);
    context.restore();
  }

  // Small text with a dark edge, readable on any background.
  label(text, x, y) {
    this.write(text, x, y, {size_mm: 11.5 * this.pixel_mm, color: "#ffffff", edge: "rgba(8, 30, 20, 0.85)"});
  }

  // Text centred at x, y.
  write(text, x, y, {size_mm, color, edge = null, isBold = false}) {
    const {context} = this;
    context.save();
    context.translate(x, y);
    context.scale(1, -1);
    context.font = `${isBold ? "bold " : "600 "}${size_mm}px system-ui, sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineJoin = "round";
    context.lineWidth = 3.5 * this.pixel_mm;
    context.strokeStyle = edge ?? color;
    if (edge) context.strokeText(text, 0, 0);
    context.fillStyle = color;
    context.fillText(text, 0, 0.06 * size_mm);
    context.restore();
  }
}
