#include "referee/rules/chip_goal.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "referee/rules/in_goal.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

struct Chip {
  const BallTouch* touch = nullptr;  // by the attackers; none: it was no chip
  double top_m = 0;                  // the highest of the ball's top since
};

// How high the ball has been since the attackers' last touch, while it has not rolled.
Chip find_chip(const TouchHistory& touches, Side scorer, double limit_m) {
  double highest_m = 0;
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

}  // namespace

std::optional<Finding> find_chip_goal(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const std::optional<Side> conceded = conceding_side(input);
  if (!conceded) return std::nullopt;
  const Side scorer = opponent_of(*conceded);
  const Chip chip = find_chip(state.play.touches, scorer, c.rules.chip_height_m);
  if (chip.touch == nullptr) return std::nullopt;
  Finding finding = offence_of(Event::kChipGoal, RuleId::kChipGoal, c, scorer, chip.touch->ended_m);
  if (chip.touch->robot) finding.robots.push_back(*chip.touch->robot);
  finding.value = chip.top_m;
  finding.evidence = fmt::format(
      "The ball in the goal was up to {:.0f} mm high since {} touched it at {:.3f} s, and has not "
      "rolled since.",
      1e3 * chip.top_m, name_of(scorer), chip.touch->ended_s);
  return finding;
}

}  // namespace autoref::referee
