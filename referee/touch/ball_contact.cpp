#include "referee/touch/ball_contact.hpp"

#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr double kTouches_m = 1_mm;
constexpr double kSeparate_m = 20_mm;

}  // namespace

bool has_ball(const TrackedRobot& robot, const TrackedBall& ball, bool had,
              const tracking::VisionNoise& noise) {
  if (ball.height_m > kRobotHeight_m) return false;
  const double gap_m =
      distance_to_hull(ball.position_m, robot.position_m, robot.heading) - kBallRadius_m;
  const double noise_m = std::hypot(noise.ball_m, noise.robot_m);
  return gap_m < (had ? kSeparate_m : kTouches_m + noise_m);
}

}  // namespace autoref::referee
