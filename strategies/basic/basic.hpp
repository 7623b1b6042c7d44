// A simple, fair team: a keeper, a wall, markers, a supporter, and an attacker that gets behind the
// ball and shoots at the open side of the goal. The team can take every kind of restart and keeps
// the required distances.
#pragma once

#include <optional>

#include "strategies/basic/roles.hpp"
#include "strategies/skills/limits.hpp"
#include "strategies/skills/look_ahead.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/skills/play_ball.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies::basic {

class Basic final : public Strategy {
 public:
  explicit Basic(const TeamContext& context);

  void decide(const TeamView& view, TeamCommands& commands) override;
  TeamRequests requests() const override { return requests_; }

 private:
  Waypoint waypoint_of(int index, const RoleAssignment& assignment) const;
  Waypoint formation_of(int index) const;
  double room_at_ball_m() const;
  Limits limits_for(bool is_keeper) const;
  void find_obstacles();
  bool is_pressed() const;
  double pass_speed_mps(double distance_m) const;
  std::optional<Aim> best_pass(int passer) const;
  Intent attack_intent(const TrackedRobot& attacker) const;
  RobotCommand attack(const RoleAssignment& assignment) const;
  RobotCommand keep(int index, const RoleAssignment& assignment) const;
  bool may_play_ball() const;
  int barred_from_ball() const;
  bool must_wait(const TrackedRobot& robot) const;
  void avoid_contact(TeamCommands& commands) const;
  void play(TeamCommands& commands);
  Vec2 allowed(const Vec2& wanted_m, const Vec2& ball_m, const Limits& limits) const;
  std::optional<Vec2> position_off_ball(const Vec2& from_m) const;
  DrivingStyle waiting_style() const;
  void line_up(TeamCommands& commands);
  void command_robots(const TeamView& view, TeamCommands& commands);
  void stand_at_penalty(TeamCommands& commands);

  TeamContext context_;
  Style style_;
  DrivingStyle driving_;
  LookAhead look_ahead_;
  TeamView now_;      // the view, extrapolated to when commands take effect
  Obstacles robots_;  // the obstacles that robots drive around
  Obstacles robots_and_ball_;
  Vec2 ball_target_m_{0, 0};  // the ball, or the position where the referee is about to place it
  int former_attacker_ = -1;
  RestartTaker taker_;
  TeamRequests requests_;
};

}  // namespace autoref::strategies::basic
