#include "experiments/scenes/situations_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "experiments/reading/top_reader.hpp"
#include "experiments/scenes/situation_reader.hpp"
#include "game/settings/setting_value.hpp"
#include "io/words.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kRemedy = "list teams by name under `attackers` and `defenders`";

int fewest_robots(const Teams& teams) {
  int fewest = kMaxRobots;
  for (const auto& [name, team] : teams) fewest = std::min(fewest, team.robots);
  return fewest;
}

void read_situations(TopReader& top, const game::Scene& scene, const SituationsOfTeams& all) {
  const SituationTeams teams{fewest_robots(*all.attackers), fewest_robots(*all.defenders)};
  const SituationReader reader(top.file(), top.locations(), all.base->field, scene, teams);
  const game::YamlEntry& list = top.required("situations");
  for (const game::YamlEntry& entry : top.file().entries(list, "situations", {}))
    (*all.situations)[entry.key] = reader.read(entry);
  if (all.situations->empty())
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

using Values = std::vector<std::pair<std::string, std::string>>;  // values by key, in order

Values values_of_robot(const DrawnRobot& robot, const Field& field) {
  Values values;
  for (const auto& number : numbers_of(robot, field))
    values.emplace_back(number.key, experiments::text_of(*number.place));
  if (robot.heading_deg)
    values.emplace_back("heading_deg", experiments::text_of(*robot.heading_deg));
  return values;
}

Values values_of_ball(const DrawnBall& ball, const Field& field) {
  Values values;
  for (const auto& number : numbers_of(ball, field))
    values.emplace_back(number.key, experiments::text_of(*number.place));
  return values;
}

std::string ends_of(const game::Scene& scene) {
  std::vector<std::string> words;
  for (const auto& [end, name] : game::names_of(game::SceneEnd{})) {
    if (end != game::SceneEnd::kTime && scene.is_ended_by(end)) words.emplace_back(name);
  }
  return fmt::format("[{}]", io::listed(words));
}

std::string flow_text(const Values& values) {
  std::string text;
  for (const auto& [key, value] : values)
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key, value);
  return fmt::format("{{ {} }}", text);
}

std::string score_of(const game::SceneWeights& weights) {
  Values values;
  game::SceneWeights::visit(weights, [&values](double weight, const Parameter& about) {
    values.emplace_back(about.name, io::text_of(weight));
  });
  return flow_text(values);
}

// A situation's settings other than its robots and ball.
Values values_of_scene(const SituationSetup& situation) {
  return {{"lasts_s", io::text_of(situation.scene.lasts_s)},
          {"score", score_of(situation.scene.weights)},
          {"ends_on", ends_of(situation.scene)},
          {"restart", std::string(autoref::name_of(situation.restart))},
          {"taken_by", situation.is_attackers_restart ? "attackers" : "defenders"},
          {"after_stop", situation.is_after_stop ? "true" : "false"}};
}

std::string robots_text(std::string_view key, const std::vector<DrawnRobot>& robots,
                        const Field& field) {
  std::string text = fmt::format("    {}:{}\n", key, robots.empty() ? " {}" : "");
  for (const DrawnRobot& robot : robots)
    text += fmt::format("      {}: {}\n", robot.number, flow_text(values_of_robot(robot, field)));
  return text;
}

void add_below(const std::string& path, const Values& values, TextByPath& all) {
  for (const auto& [key, value] : values) all[fmt::format("{}.{}", path, key)] = value;
}

// The situations' values by path, such as "situations.corner.attackers.1.x_m".
TextByPath situation_values(const SituationsByName& situations, const Field& field) {
  TextByPath all;
  for (const auto& [name, situation] : situations) {
    const std::string path = fmt::format("situations.{}", name);
    add_below(path, values_of_scene(situation), all);
    add_below(path + ".ball", values_of_ball(situation.ball, field), all);
    for (const DrawnRobot& robot : situation.attackers) {
      add_below(fmt::format("{}.attackers.{}", path, robot.number), values_of_robot(robot, field),
                all);
    }
    for (const DrawnRobot& robot : situation.defenders) {
      add_below(fmt::format("{}.defenders.{}", path, robot.number), values_of_robot(robot, field),
                all);
    }
  }
  return all;
}

}  // namespace

Key base_of_scenes_key(game::GameSettings& base) {
  Key key = base_without_teams_key(base, kRemedy, "shared by every scene");
  key.read = [read_base = key.read](TopReader& top) {
    top.refuse_assignments("teams.", "name a team instead, such as attackers.NAME.robots");
    read_base(top);
  };
  return key;
}

Key situations_key(const SituationsOfTeams& all, std::shared_ptr<const game::Scene> scene) {
  Key key{"situations", "", "start positions by name"};
  key.below = []() -> KeysBelow { return {"one situation", kSituation, situation_rows()}; };
  key.read = [all, scene = std::move(scene)](TopReader& top) { read_situations(top, *scene, all); };
  key.text = [all] { return situations_text(*all.situations, all.base->field); };
  key.values = [all] { return situation_values(*all.situations, all.base->field); };
  key.entries = [all] {
    std::vector<std::string> names;
    for (const auto& [name, situation] : *all.situations) names.push_back(name);
    return names;
  };
  return key;
}

std::string situations_text(const SituationsByName& situations, const Field& field) {
  std::string text =
      "situations:  # in the attackers' frame: the attackers defend the goal at -x\n";
  for (const auto& [name, situation] : situations) {
    text += fmt::format("  {}:\n", name);
    for (const auto& [key, value] : values_of_scene(situation))
      text += fmt::format("    {}: {}\n", key, value);
    text += fmt::format("    ball: {}\n", flow_text(values_of_ball(situation.ball, field)));
    text += robots_text("attackers", situation.attackers, field);
    text += robots_text("defenders", situation.defenders, field);
  }
  return text;
}

void check_scenes(const game::GameSettings& base, const Teams& attackers, const Teams& defenders,
                  const SituationsByName& situations) {
  check(base, attackers, "attackers");
  check(base, defenders, "defenders");
  for (const auto& [name, situation] : situations) {
    const std::string path = fmt::format("situations.{}", name);
    check_robots(situation.attackers, attackers, path + ".attackers");
    check_robots(situation.defenders, defenders, path + ".defenders");
  }
}

}  // namespace autoref::experiments
