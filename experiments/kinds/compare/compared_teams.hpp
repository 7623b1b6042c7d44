// The state of a comparison, computed from its rows: the games against each opponent, and whether
// the test is decided.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/kinds/compare/comparison.hpp"

namespace autoref::experiments {

// How much better the new team did against one opponent.
struct ComparedOpponent {
  std::string name;             // kOldTeam: the new team against the old one
  Group of_new;                 // the new team's games; it is team a
  std::optional<Group> of_old;  // the old team's games; nullopt for kOldTeam
  // The new team's goal difference minus the old team's, by pair number, without pairs that have a
  // void leg. Against itself, the old team's expected goal difference is 0, so for kOldTeam, these
  // are the new team's goal differences.
  DifferenceByPair differences;
  // Number of the new team's games, of all those played, that equal the old team's game with the
  // same seed in every frame.
  int equal_games = 0;
};

struct ComparedTeams {
  std::vector<ComparedOpponent> opponents;  // kOldTeam first
  // The test of the mean difference over all opponents. kUndecided after max_pairs, and after
  // kMostVoidPairsAtFirst.
  ComparisonState test;
  std::vector<int> pairs;   // the pair numbers that the test considered, ascending
  int last_pair = 0;        // number of the last pair considered
  int void_pairs = 0;       // number of pair numbers up to last_pair with a void leg
  bool is_decided = false;  // whether no further pairs are needed
};

// A comparison ends undecided if each of its first pair numbers, this many, has a void leg: a team
// whose program does not work would not work in the other games either.
inline constexpr int kMostVoidPairsAtFirst = 10;

// Considers pair numbers in ascending order until one lacks a row or decides the comparison. The
// verdict therefore depends neither on the number of workers nor on games played after the deciding
// pair. Pair numbers with a void leg are left out of the test.
ComparedTeams compared_teams(const Comparison& comparison, const RowsById& rows);

// The same opponents with only the games of the pair numbers that the test considered.
std::vector<ComparedOpponent> considered_opponents(const Comparison& comparison,
                                                   const ComparedTeams& compared,
                                                   const RowsById& rows);

}  // namespace autoref::experiments
