#include "soccer/frame.hpp"

namespace autoref {

Frame mirrored(const Frame& frame) {
  Frame turned = frame;
  for (Side side : kSides) {
    turned.robots[opponent_of(side)] = frame.robots[side];
    for (RobotObservation& robot : turned.robots[opponent_of(side)]) {
      robot.position_m = -robot.position_m;
      robot.heading = -robot.heading;
    }
  }
  if (turned.ball) turned.ball->position_m = -turned.ball->position_m;
  return turned;
}

}  // namespace autoref
