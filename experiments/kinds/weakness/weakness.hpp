// Weaknesses: a search for situations in which a team concedes far more than usual.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/scenes/situation.hpp"
#include "experiments/schedule/matchup_schedule.hpp"

namespace autoref::experiments {

// The situations of the scenario are families: every value given as a range is searched, so that
// the attackers score as much as possible. Four phases, each with its own seeds:
//
// 1. Search: for each family, `searches` runs of CMA-ES from random points. A candidate is a small
//    part of the family around a point.
// 2. Test: the result of each search on new scenes, compared with scenes drawn from the whole
//    family. The score in the search is too high, because the search chose what scored well.
// 3. Reduction: robots are left out of each confirmed weakness, one at a time, as long as the
//    attackers score far more than usual with the same robots, and usually not much more than with
//    all robots.
// 4. Test of the reduced situations on new scenes.
struct Weakness : ExperimentOf<Weakness> {
  static const Kind kKind;

  game::GameSettings base;  // its teams, seed, a_plays and first_kickoff are ignored
  Teams attackers;          // one team
  Teams defenders;          // one team, whose weaknesses are sought
  SituationsByName situations;
  int searches = 3;          // per family
  int iterations = 30;       // of CMA-ES, per search
  int pairs = 4;             // scenes per candidate, each played in both directions
  double spread = 0.1;       // width of a candidate's ranges as a fraction of the family's
  int test_pairs = 100;      // scenes per test
  int reduction_pairs = 30;  // scenes per attempt to leave out a robot
  // The fraction of a weakness that must remain when a robot is left out.
  double kept_share = 0.8;
  std::uint64_t seed = 1;  // master seed

  std::vector<Key> keys() override;
  // The games if no weakness were confirmed, as if all candidates scored equally. Their start
  // states are not the ones played.
  std::vector<ScheduledGame> games() const override;
  std::string caveat() const override;
  // Gives the games of all candidates of a search a common prefix.
  std::vector<ScheduledGame> trial_games(std::vector<ScheduledGame> all) const override;
  bool follows_its_rows() const override { return true; }
  bool may_end_within_a_round() const override { return false; }
  Schedule schedule(const RowsById& rows) const override;
  std::optional<std::size_t> games_of_a_round() const override;
  double default_wait_s() const override { return 600; }
  RowKind row_kind() const override { return RowKind::kScene; }
  std::vector<std::string> value_columns() const override { return {"situation"}; }
  ExperimentResults results(const RowsById& rows) const override;
};

}  // namespace autoref::experiments
