// The simple baseline team, in one file. It does not pass or mark, and has hardly any state.
#pragma once

#include "strategies/skills/limits.hpp"
#include "strategies/skills/motion.hpp"
#include "strategies/skills/play_ball.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies {

// The keeper stays on its goal line, the field player nearest to the ball drives behind the ball
// and kicks it at the goal, and the others stand in a fixed formation.
class Chaser final : public Strategy {
 public:
  explicit Chaser(const TeamContext& context) : context_(context) {}

  void decide(const TeamView& view, TeamCommands& commands) override;
  TeamRequests requests() const override { return requests_; }

 private:
  bool may_chase() const;
  int nearest_to_ball() const;
  RobotCommand chase(int index) const;
  RobotCommand stand(int index) const;
  Waypoint waypoint_of(int index) const;
  double keeper_y_m(double line_x_m) const;
  Limits limits() const;
  Obstacles obstacles_for(int index, bool keeps_off_ball) const;

  TeamContext context_;
  TeamView now_;              // the view, extrapolated to when commands take effect
  Vec2 ball_target_m_{0, 0};  // the ball, or the position where the referee is about to place it
  RestartTaker taker_;
  TeamRequests requests_;
};

}  // namespace autoref::strategies
