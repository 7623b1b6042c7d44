#include "soccer/tracks.hpp"

namespace autoref {

TrackedRobot mirrored(const TrackedRobot& robot) {
  return {robot.number,
          -robot.position_m,
          -robot.heading,
          -robot.velocity_mps,
          robot.angular_velocity_radps,
          robot.is_seen};
}

TrackedBall mirrored(const TrackedBall& ball) {
  return {-ball.position_m, -ball.velocity_mps, ball.height_m, ball.height_deviation_m,
          ball.is_height_known};
}

}  // namespace autoref
