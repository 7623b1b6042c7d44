#include "referee/rules/aimless_kick.hpp"

#include <fmt/format.h>

#include "referee/geometry/ball_out.hpp"
#include "referee/machine/ball_in_play.hpp"

namespace autoref::referee {
namespace {

bool is_over_goal_line(const Moment& moment) {
  const Field& field = moment.configuration.field;
  return moment.ball && is_out_of_field(field, moment.ball->position_m) &&
         find_exit(field, moment.ball->before_m, moment.ball->position_m).boundary ==
             Boundary::kGoal;
}

}  // namespace

std::optional<Finding> find_aimless_kick(Memory& memory, const Moment& moment) {
  const Configuration& c = moment.configuration;
  const BallTouch* kick = memory.play.touches.newest();
  if (kick == nullptr || !kick->side || !is_over_goal_line(moment)) return std::nullopt;
  const double own_end = goal_sign(*kick->side);
  const bool was_own_half = own_end * kick->ended_m.x() > 0;
  const bool is_own_line = own_end * moment.ball->position_m.x() > 0;
  const bool is_kickoff =
      began_with_kickoff(memory.play, c.field) && is_straight_from_restart(memory.play);
  if (!was_own_half || is_own_line || is_kickoff) return std::nullopt;
  Finding finding =
      offence_of(Event::kAimlessKick, RuleId::kAimlessKick, c, *kick->side, kick->ended_m);
  if (kick->robot) finding.robots.push_back(*kick->robot);
  finding.value = own_end * kick->ended_m.x();
  finding.unit = "m";
  finding.evidence = fmt::format(
      "{} kicked the ball {:.0f} mm inside its own half, and it went over the opponents' goal line "
      "untouched.",
      kick->robot ? text_of(*kick->robot) : std::string(name_of(*kick->side)), 1e3 * finding.value);
  return finding;
}

}  // namespace autoref::referee
