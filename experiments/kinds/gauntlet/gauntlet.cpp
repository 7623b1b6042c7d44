#include "experiments/kinds/gauntlet/gauntlet.hpp"

#include "experiments/analysis/saturation.hpp"
#include "experiments/kinds/results.hpp"
#include "experiments/kinds/version_keys.hpp"
#include "experiments/kinds/version_results.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kChallengers = "challengers";

Key challengers_key(Gauntlet& gauntlet) {
  Key key = versioned_teams_key(kChallengers, "the teams to test", gauntlet.challengers,
                                gauntlet.base, {1}, gauntlet.versions);
  key.read = [&gauntlet, read_teams = key.read](TopReader& top) {
    read_teams(top);
    for (const auto& [name, team] : gauntlet.challengers) {
      if (!gauntlet.teams.contains(name)) continue;
      const std::string path = std::string(kChallengers) + "." + name;
      top.file().refuse(top.locations()[path], path,
                        "a team of the field already has this name; rename one of them");
    }
  };
  return key;
}

// The challengers and the field combined.
NamedTeams everyone_in(const Gauntlet& gauntlet) {
  NamedTeams everyone = gauntlet;
  everyone.teams.insert(gauntlet.challengers.begin(), gauntlet.challengers.end());
  return everyone;
}

// Notes on teams of the field that are too strong or too weak to compare the challengers.
std::string notes_on_field(const Gauntlet& gauntlet, const std::vector<Group>& matchups) {
  if (gauntlet.challengers.size() < 2) return {};
  std::string text;
  for (const auto& [name, team] : gauntlet.teams) {
    std::vector<const Group*> games;
    for (const Group& matchup : matchups)
      if (matchup.values[1] == name) games.push_back(&matchup);
    const std::string note = saturation_text(
        name, team, games, "or the challengers against each other (autoref compare)");
    if (!note.empty()) text += "\n" + note + "\n";
  }
  return text;
}

}  // namespace

constinit const Kind Gauntlet::kKind = {
    "gauntlet", "Each challenger against each team of a fixed field.", make};

std::vector<Matchup> matchups_of(const Gauntlet& gauntlet) {
  std::vector<Matchup> matchups;
  for (const auto& [challenger, its] : played_teams(gauntlet.challengers, gauntlet.versions)) {
    for (const auto& [team, settings] : gauntlet.teams) matchups.push_back({challenger, team});
  }
  return matchups;
}

std::vector<Key> Gauntlet::keys() {
  std::vector<Key> keys = {base_key(*this), teams_key(*this, "the field", {1}),
                           challengers_key(*this)};
  for (Key& key : earlier_keys(versions)) keys.push_back(std::move(key));
  keys.push_back(pairs_key(pairs, "pairs of legs per matchup"));
  keys.push_back(seed_key(seed));
  return keys;
}

std::optional<VersionedTeams> Gauntlet::versioned_teams() {
  return VersionedTeams{&versions, &challengers, &teams, &base, seed};
}

std::vector<ScheduledGame> Gauntlet::games() const {
  refuse_too_many(2.0 * pairs * static_cast<double>(teams.size()) *
                  static_cast<double>(played_teams(challengers, versions).size()));
  check(base, teams);
  check(base, challengers, kChallengers);
  check(versions, challengers, kChallengers);
  const std::vector<Matchup> matchups = matchups_of(*this);
  return games_of(everyone_in(*this), matchups,
                  combinations_order({matchups.size() / teams.size(), teams.size()}), pairs);
}

ExperimentResults Gauntlet::results(const RowsById& rows) const {
  std::vector<Group> groups = grouped(matchups_of(*this), rows);
  std::vector<Standing> standings = standings_of_challengers(groups);
  ExperimentResults results =
      tournament_results(std::move(groups), std::move(standings), "challenger");
  add_team_differences(results);
  add_version_ratings(results, versions, rows, RatedAgainst::kField);
  const std::string notes = notes_on_field(*this, results.groups);
  if (!notes.empty()) results.table.emplace_back(notes);
  return results;
}

}  // namespace autoref::experiments
