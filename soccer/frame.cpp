#include "soccer/frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace autoref {
namespace {

bool makes_sense(const RobotObservation& robot) {
  return is_finite(robot.position_m) && is_finite(robot.heading);
}

bool has_finite_height(const BallObservation& ball) {
  return !ball.height_m || std::isfinite(*ball.height_m);
}

bool is_finite(const CameraPosition& camera) {
  return autoref::is_finite(camera.position_m) && std::isfinite(camera.height_m);
}

void rotate(PerSide<SeenRobots>& sides) {
  for (SeenRobots& robots : sides.values) {
    for (RobotObservation& robot : robots) {
      robot.position_m = -robot.position_m;
      robot.heading = -robot.heading;
    }
  }
}

void rotate(BallObservation& ball) {
  ball.position_m = -ball.position_m;
  ball.seen_from.position_m = -ball.seen_from.position_m;
}

}  // namespace

bool is_finite(const Frame& frame) {
  for (const SeenRobots& robots : frame.robots.values) {
    for (const RobotObservation& robot : robots) {
      if (!makes_sense(robot)) return false;
    }
  }
  return !frame.ball || (is_finite(frame.ball->position_m) && has_finite_height(*frame.ball) &&
                         is_finite(frame.ball->seen_from));
}

Frame finite_part(const Frame& frame) {
  Frame part = frame;
  for (SeenRobots& robots : part.robots.values) {
    const auto is_nonsense = [](const RobotObservation& robot) { return !makes_sense(robot); };
    robots.erase(std::remove_if(robots.begin(), robots.end(), is_nonsense), robots.end());
  }
  if (part.ball && !is_finite(part.ball->position_m)) part.ball.reset();
  if (part.ball && !has_finite_height(*part.ball)) part.ball->height_m.reset();
  if (part.ball && !is_finite(part.ball->seen_from)) part.ball->seen_from = {part.ball->position_m};
  return part;
}

Frame rotated(Frame frame) {
  rotate(frame.robots);
  if (frame.ball) rotate(*frame.ball);
  return frame;
}

OtherDetections rotated(OtherDetections others) {
  rotate(others.robots);
  for (BallObservation& ball : others.balls) rotate(ball);
  return others;
}

Frame mirrored(const Frame& frame) {
  Frame turned = rotated(frame);
  std::swap(turned.robots[Side::kWest], turned.robots[Side::kEast]);
  return turned;
}

}  // namespace autoref
