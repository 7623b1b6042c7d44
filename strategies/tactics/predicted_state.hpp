// What a team makes of a view: the field as it will be when its commands take effect, the ball's
// way, who gets to it first, and whose it is.
#pragma once

#include <array>
#include <optional>

#include "soccer/team_view.hpp"
#include "strategies/skills/ball_path.hpp"
#include "strategies/skills/limits.hpp"
#include "strategies/skills/obstacle_avoidance.hpp"
#include "strategies/skills/reach.hpp"
#include "strategies/strategy.hpp"
#include "strategies/tactics/style.hpp"

namespace autoref::strategies {

class PredictedState {
 public:
  PredictedState(const TeamContext& context, const Style& style);

  // Takes the next view. Every view of the game must come by.
  void update(const TeamView& view);

  const TeamContext& context() const { return context_; }
  const Field& field() const { return context_.field; }
  const RuleBook& rules() const { return context_.rules; }
  const Style& style() const { return style_; }
  const TeamView& now() const { return now_; }
  const BallPath& path() const { return path_; }
  // The ball, or where the referee is about to put it.
  const Vec2& position_m() const { return position_m_; }

  int robots() const { return static_cast<int>(now_.own.size()); }
  const TrackedRobot& robot(int index) const { return now_.own[static_cast<std::size_t>(index)]; }
  const Abilities& abilities(int index) const;
  DrivingStyle driving(int index) const;

  // When and where the robot of that index, and the first opponent, can have the ball.
  const BallInterception& interception(int index) const {
    return interceptions_[static_cast<std::size_t>(index)];
  }
  const BallInterception& theirs() const { return theirs_; }
  int their_fastest() const { return their_fastest_; }  // index, -1 without opponents

  // Whether this team has the ball or will get it first; it changes only clearly.
  bool is_ours() const { return is_ours_; }
  // Whether play stands still until a restart.
  bool is_waiting() const;
  // Whether this team takes, or is about to take, the restart.
  bool restart_is_ours() const;

  // What a place must respect right now, for a field player.
  Limits limits() const;
  // From hull to ball, where the team must keep away from it now; 0 where it need not.
  double room_at_ball_m() const;

  // Whether the rules in force let a field player touch a ball there.
  bool may_touch_at(const Vec2& ball_m) const;

  // The speed of a kick that breaks no rule in force.
  double allowed_kick_mps(double wanted_mps) const;
  // The fastest chip of the team's robots.
  double chip_limit_mps() const { return context_.robots[0].chip_mps; }

 private:
  void intercept_ball();
  void settle_possession();

  TeamContext context_;
  Style style_;
  TeamView now_;
  BallPath path_;
  Vec2 position_m_{0, 0};
  std::array<BallInterception, kMaxRobots> interceptions_;
  std::array<BallInterception, kMaxRobots> their_interceptions_;
  BallInterception theirs_;
  int their_fastest_ = -1;
  bool is_ours_ = false;
};

// Commands that bring the robot of that index to the permitted place nearest to `wanted`, around
// whatever stands in the way.
RobotCommand go_to(const PredictedState& predicted, int index, const Waypoint& wanted);

// Slows an order down that would run the robot of that index into an opponent.
void ease_off(const PredictedState& predicted, int index, RobotCommand& command);

// Those robots that the one of that index drives around; the ball is left out.
void robots_around(const PredictedState& predicted, int index, const Vec2& target_m,
                   Obstacles& obstacles);

// `position_m`, facing the ball.
Waypoint facing_ball(const PredictedState& predicted, const Vec2& position_m);

}  // namespace autoref::strategies
