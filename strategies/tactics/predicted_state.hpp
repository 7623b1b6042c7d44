// A team's prediction from a view: the robots and ball when its commands take effect, the ball's
// path, who reaches the ball first, and which team has it.
#pragma once

#include <array>
#include <optional>

#include "soccer/team_view.hpp"
#include "strategies/skills/ball_path.hpp"
#include "strategies/skills/limits.hpp"
#include "strategies/skills/look_ahead.hpp"
#include "strategies/skills/motion.hpp"
#include "strategies/strategy.hpp"
#include "strategies/tactics/style.hpp"

namespace autoref::strategies {

class PredictedState {
 public:
  PredictedState(const TeamContext& context, const Style& style);

  // Processes the next view. Call it for every view of the game.
  void update(const TeamView& view);
  // Records the team's commands for that view.
  void note(const TeamCommands& commands) { look_ahead_.note(now_.frame, commands); }

  const TeamContext& context() const { return context_; }
  const Field& field() const { return context_.field; }
  const RuleBook& rules() const { return context_.rules; }
  const Style& style() const { return style_; }
  const TeamView& now() const { return now_; }
  const BallPath& path() const { return path_; }
  // The ball, or the position where the referee is about to place it.
  const Vec2& position_m() const { return position_m_; }

  // The position from which to expect a shot at the team's own goal: the ball, shifted towards the
  // point where an opponent will reach it (the style's `anticipation`), or along the motion of an
  // opponent that already has it (`threat_lead_s`).
  const Vec2& threat_m() const { return threat_m_; }

  int robots() const { return static_cast<int>(now_.own.size()); }
  const TrackedRobot& robot(int index) const { return now_.own[static_cast<std::size_t>(index)]; }
  const Abilities& abilities(int index) const;
  DrivingStyle driving(int index) const;

  // When and where the robot with that index, or the fastest opponent, can reach the ball.
  const BallInterception& interception(int index) const {
    return interceptions_[static_cast<std::size_t>(index)];
  }
  const BallInterception& theirs() const { return theirs_; }
  int their_fastest() const {
    return their_fastest_;
  }  // index in the view; -1 if there are no opponents

  // Whether this team has the ball or will reach it first. The decision has hysteresis.
  bool is_ours() const { return is_ours_; }
  // Whether play is stopped until a restart.
  bool is_waiting() const;
  // Whether this team takes the current or next restart.
  bool restart_is_ours() const;

  // The current limits on a field player's position.
  const Limits& limits() const { return limits_; }
  // Minimum gap from hull to ball that the team must currently keep; 0 if no gap is required.
  double room_at_ball_m() const { return room_at_ball_m_; }

  // Whether the opponents' free kick is so near to the team's own area that no robot fits between
  // the ball's circle and the area, as under the Laws of 2014: they place the ball 700 mm from the
  // area, and opponents keep 500 mm from it.
  bool has_no_room_behind_kick() const;

  // Whether the rules in force allow a field player to touch a ball at `ball_m`.
  bool may_touch_at(const Vec2& ball_m) const;

  // `wanted_mps`, limited to what the rules in force allow.
  double allowed_kick_mps(double wanted_mps) const;
  // Highest speed at which the team can chip the ball.
  double chip_limit_mps() const { return context_.robots[0].chip_mps; }

 private:
  void intercept_ball();
  void settle_possession();
  Vec2 find_threat_m() const;
  double find_room_at_ball_m() const;
  // The gap between hull and ball that the rules require, without margins.
  double least_room_at_ball_m() const;
  bool awaits_their_free_kick() const;
  // The sum of all margins of a robot between the opponents' free kick and the team's own area, and
  // the room left for them; the fraction of the margins for which there is room.
  double all_margins_m() const;
  double room_behind_kick_m() const;
  double share_of_margins() const;
  Limits find_limits() const;

  TeamContext context_;
  Style style_;
  LookAhead look_ahead_;
  TeamView now_;
  BallPath path_;
  Vec2 position_m_{0, 0};
  Vec2 threat_m_{0, 0};
  std::array<BallInterception, kMaxRobots> interceptions_;
  std::array<BallInterception, kMaxRobots> their_interceptions_;
  BallInterception theirs_;
  int their_fastest_ = -1;
  bool is_ours_ = false;
  double room_at_ball_m_ = 0;
  Limits limits_;
};

// Commands that drive the robot with that index around all obstacles to the permitted position
// nearest to `wanted`.
RobotCommand go_to(const PredictedState& predicted, int index, const Waypoint& wanted);

// Reduces a command's velocity if the command would run the robot with that index into an opponent.
void ease_off(const PredictedState& predicted, int index, RobotCommand& command);

// The robots that the robot with that index must avoid on its way when it does not have the ball.
void robots_around(const PredictedState& predicted, int index, const Vec2& target_m,
                   Obstacles& obstacles);

// `position_m`, facing the ball.
Waypoint facing_ball(const PredictedState& predicted, const Vec2& position_m);

}  // namespace autoref::strategies
