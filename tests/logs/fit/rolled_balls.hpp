// The motion of made-up balls that are kicked by a robot or roll freely, with noise.
#pragma once

#include <algorithm>
#include <cmath>

#include "logs/fit/recorded_motion.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::logs {

class RolledBalls {
 public:
  explicit RolledBalls(const sim::BallParameters& ball, double noise_m = 0.001)
      : ball_(ball), noise_m_(noise_m) {
    motion_.field.length_m = 12;
    motion_.field.width_m = 9;
    motion_.interval_s = 1.0 / 60;
    motion_.ball_noise_m = noise_m;
    motion_.robots.resize(1);
  }

  // The ball rolls for `length_s`, at `speed_mps` at first, far from the robot.
  void roll(double speed_mps, double length_s) {
    const RobotSight far{{-5, -4}, 0, 0, true, true};
    for (double t_s = 0; t_s < length_s; t_s += motion_.interval_s)
      add({-5 + rolled_m(speed_mps, t_s), 1}, far);
    pause();
  }

  // A robot kicks the ball along x. It began to turn, so its heading is off by `angle_rad`.
  void kick(double speed_mps, double length_s, double angle_rad = 0) {
    const RobotSight robot{{-4, 0}, angle_rad, 0, true, true};
    const Vec2 plate_m = robot.position_m + Vec2(kFrontDistance_m + kBallRadius_m, 0);
    const double phase_s = random_.uniform() * motion_.interval_s;
    for (int i = 0; i < 20; ++i) add(plate_m, robot);
    for (double t_s = phase_s; t_s < length_s; t_s += motion_.interval_s)
      add(plate_m + Vec2(kicked_m(speed_mps, t_s), 0), robot);
    pause();
  }

  const RecordedMotion& motion() const { return motion_; }

 private:
  // With deceleration = roll_mps2 + roll_per_s * speed.
  double rolled_m(double speed_mps, double t_s) const {
    double position_m = 0;
    double now_mps = speed_mps;
    constexpr double kStep_s = 1e-3;
    for (double s = 0; s < t_s && now_mps > 0; s += kStep_s) {
      const double step_s = std::min(kStep_s, t_s - s);
      const double slower_mps = (ball_.roll_mps2 + ball_.roll_per_s * now_mps) * step_s;
      position_m += (now_mps - slower_mps / 2) * step_s;
      now_mps -= slower_mps;
    }
    return position_m;
  }
  double kicked_m(double speed_mps, double t_s) const {
    const double switch_s = speed_mps * (1 - ball_.switch_ratio) / ball_.slide_mps2;
    const double slid_s = std::min(t_s, switch_s);
    const double slid_m = speed_mps * slid_s - ball_.slide_mps2 * slid_s * slid_s / 2;
    return t_s <= switch_s ? slid_m
                           : slid_m + rolled_m(speed_mps * ball_.switch_ratio, t_s - switch_s);
  }

  void add(const Vec2& ball_m, const RobotSight& robot) {
    const double time_s = static_cast<double>(motion_.frames()) * motion_.interval_s;
    // In this order with every compiler
    const double noise_x_m = noise_m_ * random_.normal();
    const double noise_y_m = noise_m_ * random_.normal();
    const Vec2 seen_m = ball_m + Vec2(noise_x_m, noise_y_m);
    motion_.times_s.push_back(time_s);
    motion_.is_running.push_back(1);
    motion_.ball.push_back({seen_m, time_s, 0, true});
    motion_.robots[0].sights.push_back(robot);
    motion_.nearest_m.push_back((seen_m - robot.position_m).norm());
    motion_.nearest_robot.push_back(0);
  }

  // The next ball is not a continuation of this one.
  void pause() { add({0, 0}, {{0, 0}, 0, 0, true, true}); }

  sim::BallParameters ball_;
  double noise_m_;
  RecordedMotion motion_;
  RandomStream random_{5};
};

}  // namespace autoref::logs
