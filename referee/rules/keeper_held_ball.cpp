// The keeper must not hold the ball inside its own defence area for longer than 15 s (Laws 12).
// Under the 2026 rules the ball must not stay inside a defence area for longer than 10 s (Division
// A: 5 s), whether or not the keeper has it, because nobody else may play it there.
//
// Under all rule books, this time does not count as time without progress (lack_of_progress.cpp).
#include <fmt/format.h>

#include "referee/rules/rule.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "soccer/field.hpp"

namespace autoref::referee {
namespace {

bool keeper_has_ball(const RefereeInput& input, Side side, bool had) {
  for (const TrackedRobot& robot : input.tracks.robots[side]) {
    if (robot.number != input.requests[side].keeper) continue;
    return has_ball(robot, *input.tracks.ball, had, input.configuration.noise);
  }
  return false;
}

bool is_held(const RefereeInput& input, Side side, bool was_held) {
  const Configuration& c = input.configuration;
  const Vec2& ball_m = input.tracks.ball->position_m;
  if (distance_to_defence_area(c.field, side, ball_m) > 0) return false;
  return c.rules.edition == Edition::kRules2026 || keeper_has_ball(input, side, was_held);
}

Finding holding_finding(const RefereeInput& input, Side side, double held_s) {
  const Configuration& c = input.configuration;
  const RobotId keeper{side, input.requests[side].keeper};
  Finding finding = offence_of(Event::kKeeperHeldBall, RuleId::kKeeperHeldBall, c, keeper,
                               input.tracks.ball->position_m);
  finding.value = held_s;
  finding.evidence = c.rules.edition == Edition::kRules2026
                         ? fmt::format("The ball has been inside the area of {} for {:.2f} s.",
                                       colour_of(side), held_s)
                         : fmt::format("{} has held the ball inside its own area for {:.2f} s.",
                                       text_of(keeper), held_s);
  return finding;
}

std::optional<Finding> find_keeper_held_ball(RefereeState& state, const RefereeInput& input) {
  if (!input.tracks.ball) return std::nullopt;
  const double limit_s = input.configuration.rules.keeper_holding_s;
  for (const Side side : kSides) {
    std::optional<double>& since_s = state.watch.keeper_held_ball.since_s[side];
    if (!state.play.in_play || !is_held(input, side, since_s.has_value())) {
      since_s.reset();
    } else if (!since_s) {
      since_s = input.time_s();
    } else if (has_passed(*since_s, limit_s, input.time_s())) {
      return holding_finding(input, side, input.time_s() - *since_s);
    }
    if (since_s) state.watch.keeper_held_ball.last_s = input.time_s();
  }
  return std::nullopt;
}

}  // namespace

constinit const Rule kKeeperHeldBallRule{{State::kRun}, find_keeper_held_ball};

}  // namespace autoref::referee
