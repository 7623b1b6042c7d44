// Differences between the teams of a tournament that played the same opponents.
#pragma once

#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// How much better `team` did than `other` against their common opponents.
struct TeamDifference {
  std::string team;
  std::string other;
  int opponents = 0;  // teams that both of them were to play
  // Goal difference per game of `team` minus that of `other`, averaged over the opponents. Games
  // with the same pair number have the same seeds, so each pair number in which both teams
  // completed all these games gives one value.
  PairedDifference difference;
};

// The differences between any two of `teams`, in the order of `teams`, if they have common
// opponents. Sets p_holm, with Holm's correction over all of them. `matchups` come from a round
// robin or gauntlet.
std::vector<TeamDifference> team_differences(const std::vector<Group>& matchups,
                                             const std::vector<std::string>& teams);

// A team's mean goal difference per game over all of its opponents, for the pair numbers in which
// it completed its games against all of them. Empty if `matchups` do not include the team.
DifferenceByPair leads_by_pair(const std::vector<Group>& matchups, const std::string& team);

// differences.csv: one row per difference.
std::string team_differences_csv(const std::vector<TeamDifference>& differences);

// The differences as a text table, followed by an explanation; a reference to differences.csv if
// there are too many for a screen, and empty without differences.
io::TextBlocks team_differences_table(const std::vector<TeamDifference>& differences);

}  // namespace autoref::experiments
