// Totals of round robins for which independent computations give the ratings.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <vector>

#include "experiments/statistics/rated_games.hpp"

namespace autoref::experiments {

// Three teams that all play each other. One game of the last matchup was drawn.
inline const std::vector<MatchupTotals> kThree = {
    {.a = 0, .b = 1, .games = 4, .difference = 3, .wins = 3},
    {.a = 0, .b = 2, .games = 2, .difference = 5, .wins = 2},
    {.a = 1, .b = 2, .games = 4, .difference = -2, .wins = 1.5, .draws = 1}};

// The 1120 games in results/reference/roundrobin: teams by name, 40 games per matchup.
inline std::vector<MatchupTotals> reference_round_robin() {
  struct Wins {
    std::size_t a;
    std::size_t b;
    double wins;
    double draws;
  };
  std::vector<MatchupTotals> totals;
  for (const Wins& matchup : std::vector<Wins>{
           {0, 1, 40, 0},  {0, 2, 0, 0},    {0, 3, 2, 4},   {0, 4, 40, 0}, {0, 5, 17.5, 11},
           {0, 6, 1.5, 1}, {0, 7, 3.5, 5},  {1, 2, 0, 0},   {1, 3, 0, 0},  {1, 4, 40, 0},
           {1, 5, 0, 0},   {1, 6, 0, 0},    {1, 7, 0, 0},   {2, 3, 40, 0}, {2, 4, 40, 0},
           {2, 5, 40, 0},  {2, 6, 40, 0},   {2, 7, 40, 0},  {3, 4, 40, 0}, {3, 5, 38.5, 3},
           {3, 6, 28, 6},  {3, 7, 38, 0},   {4, 5, 0, 0},   {4, 6, 0, 0},  {4, 7, 0, 0},
           {5, 6, 15, 10}, {5, 7, 29.5, 3}, {6, 7, 38.5, 1}}) {
    totals.push_back({.a = matchup.a,
                      .b = matchup.b,
                      .games = 40,
                      .wins = matchup.wins,
                      .draws = matchup.draws});
  }
  return totals;
}

inline void expect_near_rating(const Eigen::VectorXd& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found(i), expected[i], 5e-9) << i;
}

}  // namespace autoref::experiments
