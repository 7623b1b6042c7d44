#include "runner/experiments/reading/situations_reader.hpp"

#include <algorithm>

#include "runner/experiments/reading/named_teams_reader.hpp"
#include "runner/experiments/reading/scene_reader.hpp"
#include "runner/experiments/reading/situation_reader.hpp"
#include "runner/experiments/situations_schedule.hpp"
#include "runner/io/errors.hpp"

namespace autoref::runner {
namespace {

constexpr const char* kRemedy = "list teams by name under `attackers` and `defenders`";

void refuse_assigned_teams(const Assignments& assignments) {
  for (const Assignment& assignment : assignments) {
    if (full_path(assignment.path).starts_with("teams."))
      throw InputError({assignment.flag}, "", "name a team instead, such as attackers.NAME.robots");
  }
}

void read_team_list(TopReader& top, const char* key, Teams& teams, GameSettings& base) {
  NamedTeamsReader(top.file(), top.locations(), top.assignments())
      .read(top.required(key), teams, base, {1, SIZE_MAX});
}

int fewest_robots(const Teams& teams) {
  int fewest = kMaxRobots;
  for (const auto& [name, team] : teams) fewest = std::min(fewest, team.robots);
  return fewest;
}

}  // namespace

Situations read_situations(TopReader& top) {
  std::vector<std::string> known = {"attackers", "defenders", "situations",
                                    "base",      "pairs",     "seed"};
  known.insert(known.end(), scene_keys().begin(), scene_keys().end());
  top.allow(known);
  refuse_assigned_teams(top.assignments());
  Situations situations;
  top.read_base(situations.base, {"teams", kRemedy});
  read_team_list(top, "attackers", situations.attackers, situations.base);
  read_team_list(top, "defenders", situations.defenders, situations.base);
  Scene scene;
  read_scene(top.file(), top.entries(), "", scene);
  const SituationTeams teams{fewest_robots(situations.attackers),
                             fewest_robots(situations.defenders)};
  const SituationReader reader(top.file(), top.locations(), situations.base.field, scene, teams);
  const YamlEntry& list = top.required("situations");
  for (const YamlEntry& entry : top.file().entries(list, "situations", {}))
    situations.situations[entry.key] = reader.read(entry);
  if (situations.situations.empty())
    top.file().refuse(list.location, "situations", "expected at least one situation");
  situations.pairs = top.pairs();
  situations.seed = top.seed();
  top.check([&situations] { scheduled_games(situations); });
  return situations;
}

}  // namespace autoref::runner
