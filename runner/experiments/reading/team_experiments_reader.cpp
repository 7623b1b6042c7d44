#include "runner/experiments/reading/team_experiments_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runner/experiments/knockout_schedule.hpp"
#include "runner/experiments/matchup_schedule.hpp"
#include "runner/experiments/reading/named_teams_reader.hpp"
#include "runner/experiments/sprt_settings.hpp"
#include "runner/io/words.hpp"

namespace autoref::runner {
namespace {

void read_base(TopReader& top, NamedTeams& named) {
  top.read_base(named.base, {"teams", "list teams by name under `teams`, beside the base"});
  named.seed = top.seed();
}

void read_teams(TopReader& top, NamedTeams& named, TeamCount count = {}) {
  const YamlEntry& teams = top.required("teams");
  NamedTeamsReader(top.file(), top.locations(), top.assignments())
      .read(teams, named.teams, named.base, count);
}

void read_challengers(TopReader& top, Gauntlet& gauntlet) {
  const YamlEntry& entry = top.required("challengers");
  NamedTeamsReader(top.file(), top.locations(), top.assignments())
      .read(entry, gauntlet.challengers, gauntlet.base, {1, SIZE_MAX});
  for (const auto& [name, team] : gauntlet.challengers) {
    if (!gauntlet.teams.contains(name)) continue;
    const std::string path = "challengers." + name;
    top.file().refuse(top.locations()[path], path,
                      "a team of the field already has this name; rename one of them");
  }
}

// Reads `order`, the teams from best to worst seed; if it is missing, sorts them by name.
void read_bracket_order(TopReader& top, Knockout& knockout) {
  for (const auto& [name, team] : knockout.teams) knockout.order.push_back(name);
  const YamlEntry* entry = top.find("order");
  if (entry == nullptr) return;
  const auto refuse = [&](const YamlLocation& location, const std::string& message) {
    top.file().refuse(location, "order", message);
  };
  const std::string expected =
      "expected every team once, the best first: " + listed(knockout.order);
  if (!entry->value.IsSequence()) refuse(value_location(*entry), expected);
  std::vector<std::string> order;
  for (const YAML::Node& node : entry->value) {
    const std::string name = node.IsScalar() ? node.Scalar() : "";
    if (!knockout.teams.contains(name))
      refuse(location_of(node), fmt::format("{}; found '{}', which is not a team", expected, name));
    if (std::find(order.begin(), order.end(), name) != order.end())
      refuse(location_of(node), fmt::format("{}; found '{}' twice", expected, name));
    order.push_back(name);
  }
  for (const std::string& name : knockout.order) {
    if (std::find(order.begin(), order.end(), name) == order.end())
      refuse(value_location(*entry), fmt::format("{}; '{}' is missing", expected, name));
  }
  knockout.order = order;
}

void read_third_place(TopReader& top, Knockout& knockout) {
  const YamlEntry* entry = top.find("third_place");
  if (entry == nullptr) return;
  knockout.third_place = top.word(*entry, "third_place", {"true", "false"}) == "true";
  if (!knockout.third_place || knockout.teams.size() >= 4) return;
  top.file().refuse(
      value_location(*entry), "third_place",
      fmt::format("needs two semi-finals, so at least 4 teams, found {}; leave it out",
                  knockout.teams.size()));
}

// Requires d0, d1 and max_pairs; the error rates and min_pairs have defaults.
void read_sprt(TopReader& top, SequentialTest& test) {
  const YamlEntry& entry = top.required("sprt");
  SettingsReader settings(top.file(), settings_of(test), top.locations());
  settings.read(entry, "sprt");
  const std::vector<YamlEntry> given = top.file().entries(entry, "sprt", settings.names());
  for (const char* key : {"d0", "d1", "max_pairs"}) {
    if (find_entry(given, key) != nullptr) continue;
    top.file().refuse(entry.location, "sprt",
                      fmt::format("the key '{}' is missing; expected something like {{ d0: 0, d1: "
                                  "1, max_pairs: 200 }}",
                                  key));
  }
  top.check([&test] { check_test(test); });
}

}  // namespace

RoundRobin read_roundrobin(TopReader& top) {
  top.allow({"teams", "base", "pairs", "seed"});
  RoundRobin robin;
  read_base(top, robin);
  read_teams(top, robin);
  robin.pairs = top.pairs();
  top.check([&robin] { scheduled_games(robin); });
  return robin;
}

SprtMatch read_sprt_match(TopReader& top) {
  top.allow({"teams", "base", "sprt", "seed"});
  SprtMatch match;
  read_base(top, match);
  read_teams(top, match, {2, 2});
  read_sprt(top, match.sprt);
  top.check([&match] { scheduled_games(match); });
  return match;
}

Gauntlet read_gauntlet(TopReader& top) {
  top.allow({"challengers", "teams", "base", "pairs", "seed"});
  Gauntlet gauntlet;
  read_base(top, gauntlet);
  read_teams(top, gauntlet, {1, SIZE_MAX});
  read_challengers(top, gauntlet);
  gauntlet.pairs = top.pairs();
  top.check([&gauntlet] { scheduled_games(gauntlet); });
  return gauntlet;
}

Knockout read_knockout(TopReader& top) {
  top.allow({"teams", "order", "third_place", "base", "seed"});
  Knockout knockout;
  read_base(top, knockout);
  // Every rule book except the paper's has extra time and shoot-outs; the base may disable them.
  if (!knockout.base.given.contains("match.knockout")) {
    knockout.base.match.knockout = knockout.base.match.rules.name != "paper";
  }
  read_teams(top, knockout, {2, kMostInKnockout});
  read_bracket_order(top, knockout);
  read_third_place(top, knockout);
  top.check([&knockout] { scheduled_games(knockout); });
  return knockout;
}

}  // namespace autoref::runner
