// Swiss tournaments: in each round, teams with similar results so far play each other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/matchup_schedule.hpp"

namespace autoref::experiments {

// In each round, every two teams that are paired with each other play `pairs` pairs of legs. The
// next round is paired once all games of a round have rows, void or not (swiss_rounds.hpp). Any
// number of rounds up to half the number of teams can be played without rematches
// (swiss_rounds.hpp).
struct Swiss : NamedTeams, ExperimentOf<Swiss> {  // 2 to 64 teams
  static const Kind kKind;

  int rounds = 1;  // 1 to most_rounds()
  int pairs = 1;   // pairs of legs per meeting; rounds * pairs is at most kMostPairs

  std::vector<Key> keys() override;
  // The games played if every game is drawn.
  std::vector<ScheduledGame> games() const override;
  std::string caveat() const override;
  bool follows_its_rows() const override { return true; }
  Schedule schedule(const RowsById& rows) const override;
  std::optional<std::size_t> games_of_a_round() const override;
  ExperimentResults results(const RowsById& rows) const override;
};

inline constexpr std::size_t kMostInSwiss = 64;  // maximum number of teams

// The number of rounds that every team needs to play every other team once.
constexpr int most_rounds(std::size_t teams) {
  return static_cast<int>(teams % 2 == 0 ? teams - 1 : teams);
}

}  // namespace autoref::experiments
