// A kick from the team's own half that crosses the opponents' goal line outside the goal without
// another touch is aimless, unless it was a kick-off (2026 Division B). The opponents get a free
// kick from the position of the kick.
#include <fmt/format.h>

#include <algorithm>

#include "referee/geometry/ball_out.hpp"
#include "referee/machine/ball_in_play.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/frame_history.hpp"

namespace autoref::referee {
namespace {

// Where the ball crossed a goal line in this frame, if it did.
std::optional<Vec2> over_goal_line_m(const RefereeInput& input) {
  const Field& field = input.configuration.field;
  if (!input.ball || !is_out_of_field(field, input.ball->position_m)) return std::nullopt;
  const Exit exit = find_exit(field, input.ball->before_m, input.ball->position_m);
  return exit.line == ExitLine::kGoal ? std::optional(exit.point_m) : std::nullopt;
}

// The ball's first detection after the last touch.
Vec2 ball_at(const RefereeInput& input) {
  const FrameHistory& frames = input.frames;
  return frames[std::min(frames.first_detection(input.last_touch.time_s), frames.newest())]
      .ball.position_m;
}

std::optional<Finding> find_aimless_kick(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const BallTouch* kick = state.play.touches.newest();
  if (kick == nullptr || !kick->side) return std::nullopt;
  const std::optional<Vec2> exit_m = over_goal_line_m(input);
  if (!exit_m) return std::nullopt;
  // Now that the ball is out, its whole path is known and may reveal that another touch was the
  // last.
  if (input.last_touch.side != kick->side) return std::nullopt;
  const std::optional<RobotId> kicker = input.last_touch.robot;
  const Vec2 from_m = kicker == kick->robot ? kick->ended_m : ball_at(input);
  const double own_end = goal_sign(*kick->side);
  const bool was_own_half = own_end * from_m.x() > 0;
  const bool is_own_line = own_end * input.ball->position_m.x() > 0;
  const bool is_kickoff =
      began_with_kickoff(state.play, c.field) && is_straight_from_restart(state.play);
  if (!was_own_half || is_own_line || is_kickoff) return std::nullopt;
  Finding finding = offence_of(Event::kAimlessKick, RuleId::kAimlessKick, c, *kick->side, from_m);
  if (kicker) finding.robots.push_back(*kicker);
  finding.value = own_end * from_m.x();
  finding.unit = "m";
  finding.details.ball_m = exit_m;
  finding.evidence = fmt::format(
      "{} kicked the ball {:.0f} mm inside its own half, and it crossed the opponents' goal line "
      "untouched.",
      kicker ? text_of(*kicker) : std::string(colour_of(*kick->side)), 1e3 * finding.value);
  return finding;
}

}  // namespace

constinit const Rule kAimlessKickRule{{State::kRun}, find_aimless_kick};

}  // namespace autoref::referee
