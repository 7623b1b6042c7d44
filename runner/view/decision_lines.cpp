#include "runner/view/decision_lines.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <vector>

#include "referee/decision.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/json.hpp"
#include "runner/io/words.hpp"
#include "runner/io/yaml_bounds.hpp"

namespace autoref::runner {
namespace {

using referee::Event;

// A decision is a line of plain values, none of them repeated.
constexpr YamlBounds kLineBounds{
    .bytes = 1 << 16, .scalar_bytes = 1 << 14, .nodes = 1000, .depth = 4};

bool is_of_interest(const std::string& event) {
  constexpr std::array kCourseOfTheGame = {Event::kBegin,        Event::kRobotsMoved,
                                           Event::kStartTimeout, Event::kReady,
                                           Event::kReadyTimeout, Event::kSignalled};
  return std::none_of(kCourseOfTheGame.begin(), kCourseOfTheGame.end(),
                      [&](Event quiet) { return name_of(quiet) == event; });
}

// Throws std::invalid_argument where it is no number.
std::string number_json(const YAML::Node& node) {
  const auto number = node.IsScalar() ? number_in(node.Scalar()) : std::nullopt;
  if (!number) throw std::invalid_argument("not a number");
  return json_number(*number);
}

std::string text_json(const YAML::Node& node) {
  return node.IsDefined() && node.IsScalar() ? json_text(node.Scalar()) : "null";
}

std::string position_json_of(const YAML::Node& node) {
  if (!node.IsDefined() || !node.IsSequence() || node.size() != 2) return "null";
  return json_list({number_json(node[0]), number_json(node[1])});
}

// Throws YAML::Exception or std::invalid_argument for what is no decision.
void add_decision(const std::string& line, std::vector<std::string>& decisions) {
  if (beyond_bounds(line, kLineBounds)) throw std::invalid_argument("no decision");
  const YAML::Node node = YAML::Load(line);
  if (!node.IsMap() || !node["event"].IsDefined()) throw std::invalid_argument("no decision");
  const std::string event = node["event"].as<std::string>();
  const std::string time = number_json(node["time_s"]);
  if (!is_of_interest(event)) return;
  decisions.push_back(JsonObject()
                          .add("time_s", time)
                          .add("event", json_text(event))
                          .add("rule", text_json(node["rule"]))
                          .add("reason", text_json(node["evidence"]))
                          .add("offender", text_json(node["offender"]))
                          .add("card", text_json(node["card"]))
                          .add("card_reason", text_json(node["card_reason"]))
                          .add("restart", text_json(node["restart"]))
                          .add("position_m", position_json_of(node["position_m"]))
                          .text());
}

}  // namespace

std::string decisions_for_page(std::string_view lines, const std::string& file) {
  std::vector<std::string> decisions;
  for (int number = 1; !lines.empty(); ++number) {
    const std::string line(lines.substr(0, lines.find('\n')));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    if (line.empty()) continue;
    try {
      add_decision(line, decisions);
    } catch (const std::exception&) {
      throw InputError({file, number, 1}, "",
                       "this is no decision of a referee, as `autoref play --events` writes them");
    }
  }
  return json_list(decisions);
}

}  // namespace autoref::runner
