// Judges five seconds of frames that no simulator made: after two seconds a yellow robot kicks the
// ball over the touch line. Prints each decision.
#include <algorithm>
#include <cstdio>
#include <string>

#include "referee/referee.hpp"
#include "soccer/robot_shape.hpp"

namespace {

constexpr double kRate_hz = 60;
constexpr int kFrames = 300;
constexpr double kKick_s = 2;
constexpr double kKickSpeed_mps = 3;
constexpr double kFriction_mps2 = 0.4;

// How far the ball has rolled `time_s` after the kick.
double rolled_m(double time_s) {
  const double rolling_s = std::clamp(time_s, 0.0, kKickSpeed_mps / kFriction_mps2);
  return kKickSpeed_mps * rolling_s - kFriction_mps2 * rolling_s * rolling_s / 2;
}

// Yellow robot 3 faces the touch line at +y, with the ball at its front; blue robot 4 looks on.
autoref::Frame frame_of(int number) {
  using autoref::Side;
  using autoref::Vec2;
  autoref::Frame frame;
  frame.number = number;
  frame.time_s = number / kRate_hz;
  frame.robots[Side::kWest].push_back({3, Vec2(0.5, 0.2), Vec2(0, 1)});
  frame.robots[Side::kEast].push_back({4, Vec2(1.5, 0.2), Vec2(-1, 0)});
  const double front_m = autoref::kFrontDistance_m + autoref::kBallRadius_m;
  frame.ball =
      autoref::BallObservation{Vec2(0.5, 0.2 + front_m + rolled_m(frame.time_s - kKick_s)), 0.0};
  return frame;
}

std::string robot_text(const std::optional<autoref::RobotId>& robot) {
  if (!robot) return "unknown";
  return std::string(name_of(robot->side)) + " " + std::to_string(robot->number);
}

void print(const autoref::referee::Decision& decision) {
  const auto restart = decision.restart();
  std::printf("%.2f s  %s  last touch: %s  restart: %s\n", decision.time_s,
              std::string(name_of(decision.finding.event)).c_str(),
              robot_text(decision.last_touch.robot).c_str(),
              restart ? name_of(*restart).c_str() : "none");
}

}  // namespace

int main() {
  autoref::referee::Configuration configuration;             // the paper's field and rules
  configuration.control = autoref::referee::Control::kNone;  // play is on throughout
  autoref::referee::AutoRef referee(configuration);
  for (int number = 0; number < kFrames; ++number) {
    referee.update(frame_of(number), {});
    for (const autoref::referee::Decision& decision : referee.decisions()) print(decision);
  }
}
