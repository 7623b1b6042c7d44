// A side must not have more robots on the field than allowed, from 10 s after a card (Laws 3 and
// 12; 2026, Yellow Card) or, in 2026, from 2 s after a start without a card. In 2026 the game
// continues with a force start, and the team is not penalised.
//
// Robots leave by driving off: a robot is off the field once all of it is beyond the lines. After
// each card, the rule makes at most one call. If both sides are at fault, the finding names
// neither, and play continues with a force start.
#include "referee/rules/too_many_robots.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "referee/geometry/restarts.hpp"
#include "referee/rules/rule.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// Whether any part of the circle that encloses the robot is within the lines.
bool reaches_field(const Field& field, const Vec2& position_m) {
  return std::abs(position_m.x()) < field.half_length_m() + kRobotRadius_m &&
         std::abs(position_m.y()) < field.half_width_m() + kRobotRadius_m;
}

// Vision sometimes detects robots that are not there, but not for as long as this. A robot that
// vision no longer sees is still tracked for half a second.
constexpr double kPatternLasts_s = 1_s;

bool is_at_fault(RefereeState& state, const RefereeInput& input, Side side) {
  CardBook& cards = state.cards[side];
  std::optional<double>& since_s = cards.too_many_since_s;
  if (robots_on_field(input, side) <= state.signal.robots_allowed[side]) {
    since_s.reset();
    return false;
  }
  if (!since_s) since_s = input.time_s();
  if (cards.too_many_called || !has_passed(*since_s, kPatternLasts_s, input.time_s())) return false;
  const RuleBook& rules = input.configuration.rules;
  if (cards.fewer_since_s)
    return has_passed(*cards.fewer_since_s, rules.too_many_s, input.time_s());
  return rules.edition == Edition::kRules2026 && state.machine_state == State::kRun &&
         has_passed(state.play.began_s, rules.too_many_start_s, input.time_s());
}

Finding fault_of(const PerSide<bool>& sides, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  Finding finding = finding_of(Event::kTooManyRobots, RuleId::kTooManyRobots, c.rules);
  const Vec2 ball_m = input.ball ? input.ball->position_m : Vec2(0, 0);
  const bool both = sides[Side::kWest] && sides[Side::kEast];
  if (!both) finding.offender = sides[Side::kWest] ? Side::kWest : Side::kEast;
  if (both || c.rules.edition == Edition::kRules2026) {
    finding.restart = {CommandKind::kForceStart, Side::kWest};
    finding.ball_to_m = neutral_position(c.field, c.rules, ball_m);
    return finding;
  }
  const Side kicker = opponent_of(*finding.offender);
  finding.restart = indirect_free_kick(c.rules, kicker);
  finding.ball_to_m = free_kick_position(c.field, c.rules, kicker, ball_m);
  return finding;
}

std::optional<Finding> find_too_many_robots(RefereeState& state, const RefereeInput& input) {
  PerSide<bool> sides;
  double since_s = input.time_s();
  for (const Side side : kSides) {
    sides[side] = is_at_fault(state, input, side);
    if (!sides[side]) continue;
    since_s = std::min(since_s, state.cards[side].fewer_since_s.value_or(state.play.began_s));
  }
  if (!sides[Side::kWest] && !sides[Side::kEast]) return std::nullopt;
  Finding finding = fault_of(sides, input);
  finding.value = input.time_s() - since_s;
  if (finding.offender) {
    finding.details.robots = robots_on_field(input, *finding.offender);
    finding.details.robots_allowed = state.signal.robots_allowed[*finding.offender];
  }
  finding.evidence =
      fmt::format("{} still has more robots than allowed {:.1f} s after a card or a start.",
                  finding.offender ? colour_of(*finding.offender) : "each side", finding.value);
  return finding;
}

}  // namespace

int robots_on_field(const RefereeInput& input, Side side) {
  const SeenRobots& robots = input.frame.robots[side];
  return static_cast<int>(
      std::count_if(robots.begin(), robots.end(), [&](const RobotObservation& robot) {
        return reaches_field(input.configuration.field, robot.position_m);
      }));
}

constinit const Rule kTooManyRobotsRule{{State::kRun, State::kWaitStop}, find_too_many_robots};

}  // namespace autoref::referee
