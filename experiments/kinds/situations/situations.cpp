#include "experiments/kinds/situations/situations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/kinds/situations/scene_reader.hpp"
#include "experiments/kinds/situations/situation_reader.hpp"
#include "experiments/kinds/situations/situations_report.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"
#include "game/settings/setting_value.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kRemedy = "list teams by name under `attackers` and `defenders`";

int fewest_robots(const Teams& teams) {
  int fewest = kMaxRobots;
  for (const auto& [name, team] : teams) fewest = std::min(fewest, team.robots);
  return fewest;
}

void read_situations(TopReader& top, const game::Scene& scene, Situations& all) {
  const SituationTeams teams{fewest_robots(all.attackers), fewest_robots(all.defenders)};
  const SituationReader reader(top.file(), top.locations(), all.base.field, scene, teams);
  const game::YamlEntry& list = top.required("situations");
  for (const game::YamlEntry& entry : top.file().entries(list, "situations", {}))
    all.situations[entry.key] = reader.read(entry);
  if (all.situations.empty())
    top.file().refuse(list.location, "situations", "expected at least one situation");
}

constexpr const char* kSituation =
    "Values are in the attackers' frame: the attackers defend the goal at -x. Each is a number, a "
    "range "
    "such as `[1.5, 3]`, or `{ mean: 2, sd: 0.1 }`. Robots that are not listed are off the field.";

std::vector<KeyRow> situation_rows() {
  return {{"`restart`",
           "`none`, `kickoff`, `direct_free`, `indirect_free`, `penalty` or `force_start`; `none`",
           "how the scene begins; `none`: play is on"},
          {"`taken_by`", "`attackers` or `defenders`; `attackers`", "who takes the restart"},
          {"`after_stop`", "true or false; false",
           "whether STOP comes first, so that the robots line up on their own"},
          {"`ball`", "`x_m`, `y_m`, `vx_mps`, `vy_mps`, `height_m`, `vz_mps`",
           "the ball; can be left out for a kick-off or a penalty kick"},
          {"`attackers`, `defenders`",
           "robots by number, with `x_m`, `y_m`, `heading_deg`, `vx_mps`, `vy_mps`, `turn_radps`",
           "the robots; without `heading_deg`, a robot faces the ball"},
          {"`from`", "`log`, `at_s`, `attackers`, `spread_m`",
           "instead of all of these: the state of an SSL log at that time"},
          {"`lasts_s`, `score`, `ends_on`", "as above", "for this situation only"}};
}

// `scene` contains the defaults for keys that a situation does not set.
Key situations_key(Situations& all, std::shared_ptr<const game::Scene> scene) {
  Key key{"situations", "", "start positions by name"};
  key.below = []() -> KeysBelow { return {"one situation", kSituation, situation_rows()}; };
  key.read = [&all, scene = std::move(scene)](TopReader& top) {
    read_situations(top, *scene, all);
  };
  key.text = [&all] { return situations_text(all); };
  key.values = [&all] { return situation_values(all); };
  key.entries = [&all] {
    std::vector<std::string> names;
    for (const auto& [name, situation] : all.situations) names.push_back(name);
    return names;
  };
  return key;
}

Key base_of_scenes_key(game::GameSettings& base) {
  Key key = base_without_teams_key(base, kRemedy, "shared by every scene");
  key.read = [read_base = key.read](TopReader& top) {
    top.refuse_assignments("teams.", "name a team instead, such as attackers.NAME.robots");
    read_base(top);
  };
  return key;
}

// The robots of a situation must exist in every team that plays it.
void check_robots(const std::vector<DrawnRobot>& robots, const Teams& teams,
                  const std::string& path) {
  for (const DrawnRobot& robot : robots) {
    for (const auto& [name, team] : teams) {
      if (robot.number < team.robots) continue;
      throw game::SettingError(
          fmt::format("{}.{}", path, robot.number),
          fmt::format(": team '{}' has {} robots, numbered from 0", name, team.robots));
    }
  }
}

void check_all(const Situations& situations) {
  check(situations.base, situations.attackers, "attackers");
  check(situations.base, situations.defenders, "defenders");
  for (const auto& [name, situation] : situations.situations) {
    const std::string path = fmt::format("situations.{}", name);
    check_robots(situation.attackers, situations.attackers, path + ".attackers");
    check_robots(situation.defenders, situations.defenders, path + ".defenders");
  }
}

// The settings of a matchup's scenes.
SharedSettings settings_of(const Situations& situations, const SituationMatchup& matchup) {
  game::GameSettings game = situations.base;
  game.a = situations.attackers.at(matchup.attackers);
  game.b = situations.defenders.at(matchup.defenders);
  game.scene = situations.situations.at(matchup.situation).scene;
  return SharedSettings(std::move(game));
}

ScheduledGame scheduled(const SituationMatchup& matchup, const SharedSettings& settings,
                        const LegSettings& its_leg, int pair, int leg) {
  const std::string played =
      fmt::format("{}+{}~{}", matchup.situation, matchup.attackers, matchup.defenders);
  return {game_id(played, pair, leg), {matchup.situation}, pair, leg, settings.with(its_leg),
          matchup.attackers,          matchup.defenders};
}

// Indices into matchups_of().
std::vector<std::size_t> playing_order(const Situations& situations) {
  return combinations_order(
      {situations.situations.size(), situations.defenders.size(), situations.attackers.size()});
}

}  // namespace

constinit const Kind Situations::kKind = {
    "situations",
    "Attacking teams against defending teams in short scenes; see [situations](../situations.md).",
    make};

std::vector<SituationMatchup> matchups_of(const Situations& situations) {
  std::vector<SituationMatchup> matchups;
  for (const auto& [situation, its] : situations.situations) {
    for (const auto& [defenders, its_team] : situations.defenders) {
      for (const auto& [attackers, team] : situations.attackers)
        matchups.push_back({situation, attackers, defenders});
    }
  }
  return matchups;
}

std::vector<Key> Situations::keys() {
  const auto scene = std::make_shared<game::Scene>();
  std::vector<Key> all = {
      base_of_scenes_key(base),
      teams_key("attackers", "the teams that are compared", attackers, base, {1}),
      teams_key("defenders", "their opponents", defenders, base, {1})};
  for (Key& key : scene_keys(scene)) all.push_back(std::move(key));
  all.push_back(situations_key(*this, scene));
  all.push_back(pairs_key(pairs, "scenes per situation and teams, each played in both directions"));
  all.push_back(seed_key(seed));
  return all;
}

std::vector<ScheduledGame> Situations::games() const {
  const std::vector<SituationMatchup> matchups = matchups_of(*this);
  refuse_too_many(2.0 * pairs * static_cast<double>(matchups.size()));
  check_all(*this);
  std::vector<SharedSettings> settings;
  settings.reserve(matchups.size());
  for (const SituationMatchup& matchup : matchups) settings.push_back(settings_of(*this, matchup));
  const std::vector<std::size_t> order = playing_order(*this);
  std::vector<ScheduledGame> games;
  for (int pair = 1; pair <= pairs; ++pair) {
    std::map<std::string, std::shared_ptr<const game::StartState>> starts;
    for (const auto& [name, situation] : situations)
      starts[name] = std::make_shared<const game::StartState>(
          drawn_state(situation, name, base.field, seed, pair));
    for (const std::size_t i : order) {
      const SharedSettings scene = settings[i].starting_from(starts.at(matchups[i].situation));
      for (const int leg : {1, 2}) {
        games.push_back(scheduled(matchups[i], scene, leg_of(seed, pair, leg), pair, leg));
        games.back().unit = (games.size() - 1) / 2;
        games.back().variant = i;
        games.back().variants = matchups.size();
      }
    }
  }
  return games;
}

ExperimentResults Situations::results(const RowsById& rows) const {
  const std::vector<SceneGroup> groups = scene_groups(*this, rows);
  const std::vector<SceneDifference> differences = scene_differences(groups);
  ExperimentResults results;
  results.files = {
      {"summary.csv", "a row per situation and teams", scenes_csv(groups)},
      {"differences.csv", "a row per two attacking teams", scene_differences_csv(differences)}};
  results.table = scenes_table(groups, differences);
  results.shown = {{scenes_rows(groups), kScenesColumns, "situations"}};
  results.json = std::make_shared<io::Json>(io::Json{{"situations", json_of(groups)}});
  return results;
}

}  // namespace autoref::experiments
