#include "experiments/kinds/situations/situations_text.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "io/words.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"

namespace autoref::experiments {
namespace {

using Values = std::vector<std::pair<std::string, std::string>>;  // by key, in order

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

// What a situation says besides its bodies.
Values values_of_scene(const SituationSetup& situation) {
  return {{"lasts_s", io::text_of(situation.scene.lasts_s)},
          {"score", score_of(situation.scene.weights)},
          {"ends_on", ends_of(situation.scene)},
          {"restart", std::string(name_of(situation.restart))},
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

void add_below(const std::string& path, const Values& values,
               std::map<std::string, std::string>& all) {
  for (const auto& [key, value] : values) all[fmt::format("{}.{}", path, key)] = value;
}

}  // namespace

std::string situations_text(const Situations& situations) {
  const Field& field = situations.base.field;
  std::string text = "situations:  # in the attackers' frame: they defend the goal at -x\n";
  for (const auto& [name, situation] : situations.situations) {
    text += fmt::format("  {}:\n", name);
    for (const auto& [key, value] : values_of_scene(situation))
      text += fmt::format("    {}: {}\n", key, value);
    text += fmt::format("    ball: {}\n", flow_text(values_of_ball(situation.ball, field)));
    text += robots_text("attackers", situation.attackers, field);
    text += robots_text("defenders", situation.defenders, field);
  }
  return text;
}

std::map<std::string, std::string> situation_values(const Situations& situations) {
  const Field& field = situations.base.field;
  std::map<std::string, std::string> all;
  for (const auto& [name, situation] : situations.situations) {
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

}  // namespace autoref::experiments
