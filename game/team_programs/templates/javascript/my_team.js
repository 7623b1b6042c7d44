#!/usr/bin/env node
// A team of one page. Robot 0 stays in the goal, the robot nearest to the ball gets behind it and
// kicks it to the opponents' goal, and the others stand in a row. Our goal is at -x.
//
// It reads one JSON object per line and answers each frame with one line. Anything else, such as
// debugging output, belongs on console.error. Every number is in metres and seconds.
"use strict";

const SPEED_MPS = 2.0; // of all robots
const STOP_MPS = 0.9; // while play is stopped: the Laws of 2014 allow 1 m/s
const TURN_RADPS = 8.0;
const KICK_MPS = 5.0;
// Distance to the ball or its path while we may not play it: the rules require 0.5 m to the hull.
const TOO_NEAR_M = 0.6;
const KEEP_OFF_M = 0.65; // the distance to which robots retreat
const PLAYABLE = ["KICKOFF", "PENALTY", "DIRECT_FREE", "INDIRECT_FREE"]; // by the team that takes the restart

function decide(frame, field) {
  const robots = frame.own;
  if (frame.play === "HALT" || robots.length === 0) return { frame: frame.frame };
  const latency = frame.latency_s; // our commands take effect this much later
  const ballX = frame.ball.x_m + frame.ball.vx_mps * latency;
  const ballY = frame.ball.y_m + frame.ball.vy_mps * latency;
  const isOurs = frame.play === "RUNNING" || (frame.ours && PLAYABLE.includes(frame.play));
  const speed = frame.play === "STOP" ? STOP_MPS : SPEED_MPS;
  const keeper = robots[0];
  let chaser = keeper; // if the ball is in our area, otherwise another robot
  if (!isInArea(field, -ballX, ballY, 0.0)) chaser = nearest(robots.slice(1), ballX, ballY);
  const commands = robots.map((robot, index) => {
    let [x, y, toX, toY] = lineUp(index, robots.length, ballX, ballY, field);
    if (isOurs && robot === chaser) [x, y, toX, toY] = attack(robot, ballX, ballY, field);
    else if (robot === keeper) [x, y, toX, toY] = guard(ballX, ballY, field);
    if (robot !== keeper) x = outOfAreas(field, x, y);
    if (!isOurs) [x, y] = keepOff(robot, x, y, ...nearestOnWay(robot, ballX, ballY, frame));
    return drive(robot, x, y, toX, toY, speed, latency);
  });
  return { frame: frame.frame, keeper: keeper.number, commands };
}

function nearest(robots, x, y) {
  let best = null;
  let least = Infinity;
  for (const robot of robots) {
    const dx = robot.x_m - x;
    const dy = robot.y_m - y;
    if (dx * dx + dy * dy < least) [best, least] = [robot, dx * dx + dy * dy];
  }
  return best;
}

// Drives through the ball towards the goal, or first to a place behind the ball, or around it.
function attack(robot, ballX, ballY, field) {
  const [toX, toY] = unit(field.length_m / 2 - ballX, -ballY);
  const dx = robot.x_m - ballX;
  const dy = robot.y_m - ballY;
  const ahead = dx * toX + dy * toY;
  const aside = dy * toX - dx * toY;
  let [back, off] = [0.2, aside > 0 ? 0.25 : -0.25];
  if (ahead < -0.05 && -0.04 < aside && aside < 0.04) [back, off] = [-0.05, 0.0];
  else if (ahead < -0.12) [back, off] = [0.15, 0.0];
  return [ballX - back * toX - off * toY, ballY - back * toY + off * toX, toX, toY];
}

// Stands on the line from the ball to the middle of our goal.
function guard(ballX, ballY, field) {
  const goalX = -field.length_m / 2;
  const [toX, toY] = unit(ballX - goalX, ballY);
  return [goalX + 0.1 + 0.2 * toX, 0.3 * toY, toX, toY];
}

// Stands in a row across our half, facing the ball.
function lineUp(index, count, ballX, ballY, field) {
  const x = -field.length_m / 5;
  const y = ((index - count / 2) * field.width_m) / (count + 1);
  return [x, y, ...unit(ballX - x, ballY - y)];
}

// Whether a point is in the opponents' defence area, approximated by a box; for ours, pass -x.
function isInArea(field, x, y, margin) {
  let half = field.defence_area_straight_m / 2;
  if (!field.defence_area_is_box) half = half + field.defence_area_depth_m;
  const depth = field.defence_area_depth_m + margin;
  return x > field.length_m / 2 - depth && -half - margin < y && y < half + margin;
}

// The nearest x at which a robot is in neither defence area.
function outOfAreas(field, x, y) {
  const limit = field.length_m / 2 - field.defence_area_depth_m - 0.3;
  if (isInArea(field, x, y, 0.3)) return limit;
  return isInArea(field, -x, y, 0.3) ? -limit : x;
}

// The point nearest to the robot on the ball's path to the referee's target.
function nearestOnWay(robot, ballX, ballY, frame) {
  if (frame.placement_x_m === null) return [ballX, ballY];
  const [endX, endY] = [frame.placement_x_m, frame.placement_y_m];
  const [wayX, wayY] = [endX - ballX, endY - ballY];
  const whole = wayX * wayX + wayY * wayY;
  const along = (robot.x_m - ballX) * wayX + (robot.y_m - ballY) * wayY;
  if (along <= 0) return [ballX, ballY];
  if (along >= whole) return [endX, endY];
  return [ballX + (along / whole) * wayX, ballY + (along / whole) * wayY];
}

// Moves away from a point if the robot is near it; otherwise goes to (x, y), but around the point.
function keepOff(robot, x, y, nearX, nearY) {
  const [dx, dy] = [robot.x_m - nearX, robot.y_m - nearY];
  if (dx * dx + dy * dy < TOO_NEAR_M * TOO_NEAR_M) [x, y] = [robot.x_m, robot.y_m];
  const [fromX, fromY] = unit(dx, dy);
  const lack = KEEP_OFF_M - (x - nearX) * fromX - (y - nearY) * fromY;
  return lack > 0 ? [x + lack * fromX, y + lack * fromY] : [x, y];
}

// A command that brings the robot to (x, y), facing the direction (toX, toY).
function drive(robot, x, y, toX, toY, most, latency) {
  let vx = 3 * (x - robot.x_m - robot.vx_mps * latency);
  let vy = 3 * (y - robot.y_m - robot.vy_mps * latency);
  const speed = Math.sqrt(vx * vx + vy * vy);
  if (speed > most) [vx, vy] = [(vx / speed) * most, (vy / speed) * most];
  const [frontX, frontY] = [robot.heading_x, robot.heading_y];
  let turn = frontX * toY - frontY * toX; // the sine of the angle to turn by
  if (frontX * toX + frontY * toY < 0) turn = turn > 0 ? 1.0 : -1.0;
  return {
    robot: robot.number,
    vx_mps: vx * frontX + vy * frontY, // forward
    vy_mps: vy * frontX - vx * frontY, // to its left
    angular_velocity_radps: TURN_RADPS * turn,
    kick_mps: KICK_MPS, // takes effect as soon as the ball is at the kicker
  };
}

function unit(x, y) {
  const length = Math.sqrt(x * x + y * y);
  return length > 0 ? [x / length, y / length] : [1.0, 0.0];
}

function main() {
  let field = null;
  process.stdout.write("autoref-team 1 json\n");
  const lines = require("node:readline").createInterface({ input: process.stdin });
  lines.on("line", (line) => {
    const message = JSON.parse(line);
    if (message.start) field = message.start.field;
    else if (message.frame) process.stdout.write(JSON.stringify(decide(message.frame, field)) + "\n");
    else lines.close(); // the game has ended
  });
}

main();
