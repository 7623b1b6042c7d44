#include "experiments/kinds/compare/comparison.hpp"

#include <fmt/format.h>

#include "experiments/kinds/compare/compared_teams.hpp"
#include "experiments/kinds/compare/comparison_report.hpp"
#include "experiments/reading/named_teams_reader.hpp"
#include "experiments/reading/settings_text.hpp"
#include "experiments/reading/top_reader.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kAgainst = "against";
constexpr const char* kComparisonTest = "test";
constexpr Range kComparedPairs = {1, kMostPairs};

Key old_and_new_key(Comparison& comparison) {
  Key key = teams_key(comparison, "the two teams to compare, called `old` and `new`", {2, 2});
  key.value = "`old` and `new`";
  key.read = [&comparison, read_teams = key.read](TopReader& top) {
    read_teams(top);
    for (const char* name : {kOldTeam, kNewTeam}) {
      if (comparison.teams.contains(name)) continue;
      top.file().refuse(top.required("teams").location, "teams",
                        fmt::format("the team '{}' is missing; a comparison has the teams {} and "
                                    "{}, such as {}: {{ strategy: basic }}",
                                    name, kOldTeam, kNewTeam, name));
    }
  };
  key.entries = nullptr;  // every game belongs to one of them
  return key;
}

Key against_key(Comparison& comparison) {
  Key key = teams_key(kAgainst, "opponents that both teams play as well", comparison.against,
                      comparison.base, {1});
  key.value += "; none";
  key.read = [&comparison, read_teams = key.read](TopReader& top) {
    if (top.find(kAgainst) == nullptr) {
      top.refuse_assignments(std::string(kAgainst) + ".", "there are no common opponents");
      return;
    }
    read_teams(top);
    for (const char* name : {kOldTeam, kNewTeam, kAllOpponents}) {
      if (!comparison.against.contains(name)) continue;
      const std::string path = fmt::format("{}.{}", kAgainst, name);
      top.file().refuse(top.locations()[path], path,
                        fmt::format("the names {}, {} and {} are taken; rename the opponent",
                                    kOldTeam, kNewTeam, kAllOpponents));
    }
  };
  key.text = [&comparison, text_of_teams = key.text] {
    return comparison.against.empty() ? "" : text_of_teams();
  };
  return key;
}

Key test_key(Comparison& comparison) {
  Key key{kComparisonTest, "", "when the comparison ends"};
  key.below = [&comparison]() -> KeysBelow {
    return {"the test", "", rows_of(settings_of(comparison.test))};
  };
  key.read = [&comparison](TopReader& top) {
    const game::YamlEntry* entry = top.find(kComparisonTest);
    if (entry == nullptr) return;
    game::SettingsReader(top.file(), settings_of(comparison.test), top.locations())
        .read(*entry, kComparisonTest);
  };
  key.text = [&comparison] { return text_of(settings_of(comparison.test)); };
  key.pairs = &comparison.test.max_pairs;
  return key;
}

// All teams by name.
NamedTeams everyone_in(const Comparison& comparison) {
  NamedTeams everyone = comparison;
  everyone.teams.insert(comparison.against.begin(), comparison.against.end());
  return everyone;
}

}  // namespace

constinit const Kind Comparison::kKind = {
    "compare", "Plays until it is known whether a new team is better than an old one.", make};

std::vector<Matchup> matchups_of(const Comparison& comparison) {
  std::vector<Matchup> matchups = {{kNewTeam, kOldTeam}};
  for (const auto& [opponent, team] : comparison.against) {
    matchups.push_back({kNewTeam, opponent});
    matchups.push_back({kOldTeam, opponent});
  }
  return matchups;
}

std::vector<game::Setting> settings_of(ComparisonTest& test) {
  const std::string branch = kComparisonTest;
  return {{branch + ".least",
           &test.least,
           kLeastDifference,
           {},
           "goals per game",
           "smallest difference that matters"},
          {branch + ".max_pairs",
           &test.max_pairs,
           kComparedPairs,
           {},
           "",
           "pairs of legs per opponent after which the comparison ends undecided"}};
}

std::vector<Key> Comparison::keys() {
  return {base_key(*this), old_and_new_key(*this), against_key(*this), test_key(*this),
          seed_key(seed)};
}

std::vector<ScheduledGame> Comparison::games() const {
  check(base, teams);
  check(base, against, kAgainst);
  if (base.match.on_team_fault == referee::OnTeamFault::kForfeit) {
    throw game::SettingError("match.on_team_fault",
                             ": a comparison counts goals, of which a forfeited game says nothing; "
                             "leave the key out, then such a game is void");
  }
  const std::vector<Matchup> matchups = matchups_of(*this);
  return games_of(everyone_in(*this), matchups, combinations_order({matchups.size()}),
                  test.max_pairs);
}

std::string Comparison::caveat() const {
  return "at most, since the comparison ends once it is decided";
}

Schedule Comparison::schedule(const RowsById& rows) const {
  const ComparedTeams compared = compared_teams(*this, rows);
  std::vector<ScheduledGame> all = games();
  const std::size_t needed = compared.is_decided ? 2 * matchups_of(*this).size() *
                                                       static_cast<std::size_t>(compared.last_pair)
                                                 : all.size();
  return {std::move(all), needed};
}

bool Comparison::is_decided(const RowsById& rows) const {
  return compared_teams(*this, rows).is_decided;
}

ExperimentResults Comparison::results(const RowsById& rows) const {
  return comparison_results(*this, rows);
}

}  // namespace autoref::experiments
