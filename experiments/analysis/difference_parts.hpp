// Where the goal difference of a comparison comes from: the parts that add up to it.
//
// With xG and xGOT as in game/play_counts/play_counts.hpp, a team's goal difference in a game is
// the sum of what it contributes, minus the sum of what the opponents contribute:
//
//     chances       xG of its possession chains
//     finishing     xGOT - xG: where it aimed, compared with the average shot
//     saves         xGOT of the opponents - goals of the opponents, except own goals: what its
//                   keeper and its other robots saved, compared with the average defence
//     own goals     counted as negative numbers
//
// Chances are divided further in two ways: by how the team gained the ball, and by whether it
// completed a pass.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/team_games.hpp"
#include "experiments/statistics/interval.hpp"

namespace autoref::experiments {

// How much better the new team did in one respect, in goals per game: means over all games.
struct DifferencePart {
  std::string name;  // "chances from corner kicks"
  // What each team contributed; for goals, how many it scored. With common opponents, the
  // difference also depends on what these contributed.
  double of_new = 0;
  double of_old = 0;
  // The difference has three sources: the games between the two teams, and, against common
  // opponents, what happened at the opponents' goals and at the teams' own goals.
  double each_other = 0;
  double attack = 0;
  double defence = 0;
  double mean = 0;                   // each_other + attack + defence
  std::optional<Interval> interval;  // anytime_interval() over pair numbers
  double p = 1;                      // anytime_p() of a mean of 0
  double p_holm = 1;                 // with Holm's correction over the parts that can be named
};

struct DifferenceParts {
  std::vector<DifferencePart> by_start;   // chances, by ChainStart
  std::vector<DifferencePart> by_passes;  // the same chances, with and without a pass
  DifferencePart chances;                 // their sum: the difference in xG
  std::vector<DifferencePart> others;     // finishing, saves, own goals
  DifferencePart goals;                   // chances + others: the difference in goals

  // The part with the smallest p, other than the sums; nullptr without parts.
  const DifferencePart* strongest_candidate() const;
  // The same part if its p_holm is at most kSignificant; otherwise nullptr.
  const DifferencePart* most_certain() const;
};

// Divides the mean difference over all opponents. Every game of these pair numbers must have a row,
// and none of them may be void.
DifferenceParts difference_parts(const std::vector<PairedOpponent>& opponents,
                                 const std::vector<int>& pairs, const RowsById& rows);

}  // namespace autoref::experiments
