#include "runner/team_experiments_reader.hpp"

#include <fmt/format.h>

#include "runner/matchup_plan.hpp"
#include "runner/named_teams_reader.hpp"
#include "runner/sprt_settings.hpp"

namespace autoref::runner {
namespace {

void read_teams(TopReader& top, NamedTeams& named, TeamCount count = {}) {
  top.read_base(named.base, {"teams", "its teams stand beside the base, by their names"});
  NamedTeamsReader(top.file(), top.places()).read(top.required("teams"), named, count);
  named.seed = top.seed();
}

// A test needs its claims and its end; how often it may err, and when it may end, have defaults.
void read_sprt(TopReader& top, SequentialTest& test) {
  const YamlEntry& entry = top.required("sprt");
  SettingsReader settings(top.file(), settings_of(test), top.places());
  settings.read(entry, "sprt");
  const std::vector<YamlEntry> given = top.file().entries(entry, "sprt", settings.names());
  for (const char* key : {"d0", "d1", "max_pairs"}) {
    if (find_entry(given, key) != nullptr) continue;
    top.file().refuse(entry.place, "sprt",
                      fmt::format("the key '{}' is missing; expected such as {{ d0: 0, d1: 1, "
                                  "max_pairs: 200 }}",
                                  key));
  }
  top.check([&test] { check_test(test); });
}

}  // namespace

RoundRobin read_roundrobin(TopReader& top) {
  top.allow({"teams", "base", "pairs", "seed"});
  RoundRobin robin;
  read_teams(top, robin);
  robin.pairs = top.pairs();
  top.check([&robin] { plan(robin); });
  return robin;
}

Match read_match(TopReader& top) {
  top.allow({"teams", "base", "sprt", "seed"});
  Match match;
  read_teams(top, match, {2, 2});
  read_sprt(top, match.sprt);
  top.check([&match] { plan(match); });
  return match;
}

}  // namespace autoref::runner
