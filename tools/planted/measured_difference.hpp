// How many games different measures need to find the same difference between two teams.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/statistics/interval.hpp"

namespace autoref::tools {

// A measure's value for each pair of legs: how much better the new team did, in goals per game.
struct MeasuredPairs {
  std::string measure;
  std::vector<double> differences;
};

// What the sequential rule of comparisons decides if the pairs are played in random orders.
struct OrderedDecisions {
  double right = 0;  // share of orders in which it finds the right team to be better
  double wrong = 0;  // share of orders in which it finds the other team to be better
  // The median number of games until a decision; nullopt if half of the orders or more end
  // undecided.
  std::optional<int> median_games;
};

// A number of games divided by the number that goals need, at most kMostRelativeGames.
struct RelativeGames {
  double factor = 0;
  experiments::Interval interval;  // bootstrap percentiles
};

// More games than this many times those with goals are not worth counting. It also stands for
// measures that favour the other team.
inline constexpr double kMostRelativeGames = 100;

struct MeasuredDifference {
  std::string measure;
  double mean = 0;  // goals per game
  std::optional<experiments::Interval> interval;
  double sd = 0;                      // of a pair's difference, in goals
  std::optional<double> correlation;  // with the differences in goals; nullopt without spread
  double minus_goals = 0;             // mean minus the mean difference in goals
  std::optional<experiments::Interval> minus_goals_interval;
  // Minimum number of games for a power of kPower, if mean and sd are the true ones; nullopt
  // without spread, if the mean is 0 or favours the other team than goals do, and if there would be
  // more than kMostScheduledGames.
  std::optional<int> games;
  RelativeGames relative;
  // The same factor if the measure's true mean were that of the goals.
  double relative_with_equal_means = 0;
  OrderedDecisions decisions;
};

// Of a two-sided t test at the level 0.05.
inline constexpr double kPower = 0.8;

// Compares every measure with the first one, the goals. All must have the same pairs, at least two
// of them. The team with the higher mean of goals is taken to be the better one.
//
// The games are played one pair after the other in `decisions`, until anytime_interval() excludes
// 0. The draws come from fixed random streams, the same for every measure.
std::vector<MeasuredDifference> measured_differences(const std::vector<MeasuredPairs>& measures);

// How many games a measure needs relative to goals, for the same power: the ratio of both measures'
// (sd / mean)^2, in large samples. kMostRelativeGames if their means have different signs, or if a
// mean or the spread of the goals is 0.
double relative_games(std::span<const double> differences, std::span<const double> goals);

}  // namespace autoref::tools
