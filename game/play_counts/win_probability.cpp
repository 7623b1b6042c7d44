#include "game/play_counts/win_probability.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "game/play_counts/rule_book_models.hpp"
#include "soccer/units.hpp"

namespace autoref::game {
namespace {

// About the mean length of a spell of play, which is 6 to 12 s by the referee's clock in the games
// to which the models were fitted, depending on the rule book. The share of spells that end before
// the end of the game is 1 - exp(-time left / kSpell_s).
constexpr double kSpell_s = 7.0_s;

constexpr WinModel kWinModels[] = {
#define AUTOREF_WIN_MODEL(...) {__VA_ARGS__},
#include "game/play_counts/win_models.def"
#undef AUTOREF_WIN_MODEL
};

// The probabilities of each number of goals.
using Goals = std::array<double, WinModel::kMostGoals + 1>;

// The negative binomial distribution: Poisson with a rate that is gamma distributed with this shape
// and rate, over a time of 1. Computed from logarithms, since single terms may be tiny.
Goals goals_of(double shape, double rate) {
  Goals goals{};
  const double log_share = -std::log1p(rate);
  for (std::size_t n = 1; n < goals.size(); ++n) {
    const auto number = static_cast<double>(n);
    goals[n] = goals[n - 1] + log_share + std::log((shape + number - 1) / number);
  }
  const double largest = *std::max_element(goals.begin(), goals.end());
  double sum = 0;
  for (double& one : goals) {
    one = std::exp(one - largest);
    sum += one;
  }
  for (double& one : goals) one /= sum;
  return goals;
}

// The result if west leads by this many goals and both score these numbers of goals from now on.
WinProbability result_of(int lead, const Goals& west, const Goals& east) {
  WinProbability result;
  std::array<double, WinModel::kMostGoals + 2> fewer{};  // that east scores fewer than n goals
  for (std::size_t n = 0; n < east.size(); ++n) fewer[n + 1] = fewer[n] + east[n];
  for (std::size_t n = 0; n < west.size(); ++n) {
    const int draw_at = static_cast<int>(n) + lead;  // goals of east for a draw
    const auto index = static_cast<std::size_t>(std::clamp(draw_at, 0, WinModel::kMostGoals + 1));
    result.west += west[n] * fewer[index];
    if (draw_at >= 0 && draw_at <= WinModel::kMostGoals) result.draw += west[n] * east[index];
  }
  result.east = std::max(0.0, 1 - result.west - result.draw);
  return result;
}

}  // namespace

WinProbability WinModel::probability(const MatchState& match) const {
  const double left_s = std::max(match.left_s, 0.0);
  const auto goals_from_now = [&](Side side) {
    const double seen = (1 - xg_share) * match.goals[side] + xg_share * match.xg[side];
    const int more_robots = match.robots[side] - match.robots[opponent_of(side)];
    const double effective_s = std::max(left_s * std::exp(per_robot * more_robots), 1e-3);
    return goals_of(prior_goals + seen, (prior_s + match.played_s) / effective_s);
  };
  const Goals west = goals_from_now(Side::kWest);
  const Goals east = goals_from_now(Side::kEast);
  const int lead = match.goals[Side::kWest] - match.goals[Side::kEast];
  WinProbability mean;
  const auto add = [&](double weight, int after) {
    const WinProbability result = result_of(after, west, east);
    mean.west += weight * result.west;
    mean.draw += weight * result.draw;
    mean.east += weight * result.east;
  };
  const double in_time = 1 - std::exp(-left_s / kSpell_s);
  const double west_scores = in_time * match.scores[Side::kWest];
  const double east_scores = in_time * match.scores[Side::kEast];
  add(west_scores, lead + 1);
  add(east_scores, lead - 1);
  add(1 - west_scores - east_scores, lead);
  return mean;
}

const WinModel& win_model(std::string_view rules) { return model_for<WinModel>(rules, kWinModels); }

}  // namespace autoref::game
