#include "experiments/kinds/swiss/swiss.hpp"

#include <fmt/format.h>

#include "experiments/kinds/results.hpp"
#include "experiments/kinds/swiss/swiss_report.hpp"
#include "experiments/kinds/swiss/swiss_rounds.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "game/settings/setting_value.hpp"

namespace autoref::experiments {
namespace {

Key rounds_key(Swiss& swiss) {
  Key key{"rounds", "whole number",
          "rounds to play: at most the number of teams if it is odd, otherwise one fewer"};
  key.read = [&swiss](TopReader& top) {
    swiss.rounds = top.whole_number("rounds", 1, most_rounds(kMostInSwiss));
  };
  key.text = [&swiss] { return fmt::format("rounds: {}\n", swiss.rounds); };
  return key;
}

std::size_t games_in_round(const Swiss& swiss) {
  return swiss.teams.size() / 2 * games_per_meeting(swiss);
}

void check_swiss(const Swiss& swiss) {
  const std::size_t teams = swiss.teams.size();
  const int most = most_rounds(teams);
  if (swiss.rounds < 1 || swiss.rounds > most) {
    throw game::SettingError(
        "rounds", fmt::format(" is {}; {} teams can play from 1 to {}", swiss.rounds, teams, most));
  }
  if (swiss.rounds * swiss.pairs > kMostPairs) {
    throw game::SettingError(
        "pairs", fmt::format(" is {}; in {} rounds, at most {} are possible", swiss.pairs,
                             swiss.rounds, kMostPairs / swiss.rounds));
  }
  refuse_too_many(static_cast<double>(games_in_round(swiss)) * swiss.rounds);
  check(swiss.base, swiss.teams);
}

}  // namespace

constinit const Kind Swiss::kKind = {"swiss", "Rounds between teams with similar results so far.",
                                     make};

std::vector<Key> Swiss::keys() {
  return {base_key(*this), teams_key(*this, "who takes part", {2, kMostInSwiss}), rounds_key(*this),
          pairs_key(pairs, "pairs of legs per meeting of two teams"), seed_key(seed)};
}

std::vector<ScheduledGame> Swiss::games() const {
  check_swiss(*this);
  return games_of(*this, rounds_if_drawn(*this));
}

std::string Swiss::caveat() const {
  return "assuming that every game is drawn; who meets whom after round 1 depends on the results";
}

Schedule Swiss::schedule(const RowsById& rows) const {
  return {games_of(*this, rounds_of(*this, rows)),
          games_in_round(*this) * static_cast<std::size_t>(rounds)};
}

std::optional<std::size_t> Swiss::games_of_a_round() const { return games_in_round(*this); }

ExperimentResults Swiss::results(const RowsById& rows) const {
  const SwissRounds played = rounds_of(*this, rows);
  std::vector<Group> groups = grouped(matchups_of(played), rows);
  std::vector<Standing> standings = standings_of(played, groups);
  ExperimentResults results = tournament_results(std::move(groups), std::move(standings), "team");
  add_rounds(results, played);
  return results;
}

}  // namespace autoref::experiments
