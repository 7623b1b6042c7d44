// A goal does not count if the ball's top has been above 150 mm since the attackers' last touch,
// unless the ball has rolled since (Laws 2014, law 12). The restart is an indirect free kick from
// the position of that touch.
//
// A ball of unknown height counts as being on the ground, because most balls are. If an unknown
// robot has touched the ball since the attackers' touch, that robot may have been a team-mate, so
// the goal stands. If the ball has rolled and a defender then lifts it into its own goal, the goal
// also stands.
#include <fmt/format.h>
#include <algorithm>

#include "referee/rules/goals/in_goal.hpp"
#include "referee/rules/rule.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

struct Chip {
  const BallTouch* touch = nullptr;  // touch by the attackers; null if it was not a chip
  double top_m = 0;                  // greatest height of the ball's top since that touch
};

// The attackers' last touch and the greatest height of the ball since, if the ball has not rolled.
Chip find_chip(const TouchHistory& touches, Side scorer, double limit_m) {
  double highest_m = 0;
  // Searches backwards from the newest touch and skips touches by defenders.
  for (int back = 0; touches.has(back); ++back) {
    const BallTouch& touch = touches.at(back);
    if (!touch.side || touch.rolled) return {};
    highest_m = std::max(highest_m, touch.highest_m);
    if (touch.side != scorer) continue;
    const double top_m = highest_m + 2 * kBallRadius_m;
    return {top_m > limit_m ? &touch : nullptr, top_m};
  }
  return {};
}

std::optional<Finding> find_chipped_goal(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const std::optional<Side> conceded = conceding_side(state.play, input);
  if (!conceded) return std::nullopt;
  const Side scorer = opponent_of(*conceded);
  const Chip chip = find_chip(state.play.touches, scorer, c.rules.chip_height_m);
  if (chip.touch == nullptr) return std::nullopt;
  Finding finding =
      offence_of(Event::kChippedGoal, RuleId::kChippedGoal, c, scorer, chip.touch->ended_m);
  if (chip.touch->robot) finding.robots.push_back(*chip.touch->robot);
  finding.value = chip.top_m;
  add_shot(finding, state.play.touches, input, scorer);
  finding.evidence = fmt::format(
      "The ball in the goal rose to {:.0f} mm after {} touched it at {:.3f} s, and has not "
      "rolled since.",
      1e3 * chip.top_m, colour_of(scorer), chip.touch->ended_s);
  return finding;
}

}  // namespace

constinit const Rule kChippedGoalRule{{State::kRun}, find_chipped_goal};

}  // namespace autoref::referee
