// The bodies of a case: robots that follow the script, and a ball that rolls, flies, bounces off
// robots and sticks to a robot that carries it. This is not a physics engine: it models only the
// motion that the rules need.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "soccer/frame.hpp"
#include "tests/referee/rules/case.hpp"

namespace autoref::referee {

class StagedBodies {
 public:
  explicit StagedBodies(double deceleration_mps2 = 0.3) : deceleration_mps2_(deceleration_mps2) {}

  void put(const RobotId& id, const Vec2& at_m, const Vec2& heading) {
    robots_[id] = {at_m, heading, at_m, 0, heading, 0, true, Vec2(0, 0)};
  }
  // Puts the robot with its plate a millimetre behind the ball.
  void put_behind_ball(const RobotId& id, const Vec2& heading);
  void put_ball(const Vec2& at_m);
  void clear_robots() { robots_.clear(); }
  void show_ball(bool seen) { ball_.is_seen = seen; }
  // Moves a resting ball towards the position by at most `at_most_m`.
  void place_ball(const Vec2& to_m, double at_most_m);

  // Throws std::runtime_error if a kicking robot is not at the ball, or a robot is unknown.
  void obey(const Cue& cue);
  void advance(double duration_s);

  // The frame that vision sees, without noise.
  Frame look() const;
  Vec2 ball_m() const { return ball_.at_m; }

 private:
  struct Robot {
    Vec2 at_m{0, 0};
    Vec2 heading{1, 0};
    Vec2 to_m{0, 0};
    double speed_mps = 0;
    Vec2 towards{1, 0};
    double turn_radps = 0;
    bool is_seen = true;
    Vec2 velocity_mps{0, 0};
  };
  struct Ball {
    Vec2 at_m{0, 0};
    Vec2 velocity_mps{0, 0};
    double height_m = 0;  // height of the lowest point
    double upwards_mps = 0;
    bool is_seen = true;
    double rolls_below_mps = 0;  // a kicked ball slides until it is this slow
  };

  Robot& robot(const RobotId& id);
  Vec2 plate_m(const Robot& robot, double gap_m) const;
  void kick(const Cue& cue);
  void step(double duration_s);
  void drive(Robot& robot, double duration_s) const;
  double carpet_mps2(double speed_mps) const;  // deceleration of a ball on the ground
  void fly(double duration_s);
  void meet(const RobotId& id, const Robot& robot);

  double deceleration_mps2_;
  std::map<RobotId, Robot> robots_;
  Ball ball_;
  std::set<RobotId> carriers_;
};

}  // namespace autoref::referee
