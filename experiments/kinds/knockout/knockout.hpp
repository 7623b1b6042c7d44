// Knockouts: the winner of a tie advances, the loser is eliminated.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/matchup_schedule.hpp"

namespace autoref::experiments {

// A tie is one game under the base's rules. It is replayed if it is void or drawn, which is rare
// with `match.knockout`. If it is still undecided after kMostAttempts games, the better seed
// advances.
struct Knockout : NamedTeams, ExperimentOf<Knockout> {  // 2 to 64 teams
  static const Kind kKind;

  std::vector<std::string> order;  // all teams, the best seed first
  bool third_place = false;        // whether the losing semi-finalists play for third place

  std::vector<Key> keys() override;
  // The games played if the better seed wins every tie in its first game, without replays.
  std::vector<ScheduledGame> games() const override;
  std::string caveat() const override;
  bool follows_its_rows() const override { return true; }
  // Each tie without known teams counts as one needed game, so the experiment is not complete until
  // all teams in the bracket are known and have played.
  Schedule schedule(const RowsById& rows) const override;
  std::string why_no_pairs() const override;
  ExperimentResults results(const RowsById& rows) const override;
};

inline constexpr std::size_t kMostInKnockout = 64;
// Maximum number of games of one tie: the first and five replays.
inline constexpr int kMostAttempts = 6;

}  // namespace autoref::experiments
