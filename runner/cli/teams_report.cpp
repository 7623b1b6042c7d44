#include "runner/cli/teams_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "runner/io/json.hpp"
#include "runner/io/table.hpp"

namespace autoref::runner {
namespace {

using strategies::Entry;
using strategies::Parameter;

const std::vector<Align> kAllLeft(5, Align::kLeft);

std::vector<std::string> cells_of(const Parameter& parameter) {
  return {std::string(parameter.name), std::string(parameter.unit),
          fmt::format("{}", parameter.standard),
          fmt::format("{} to {}", parameter.least, parameter.most), std::string(parameter.about)};
}

Json json_of(const Parameter& parameter) {
  return {{"name", parameter.name},   {"unit", parameter.unit}, {"default", parameter.standard},
          {"least", parameter.least}, {"most", parameter.most}, {"about", parameter.about}};
}

Json json_of(const Entry& team) {
  Json parameters = Json::array();
  for (const Parameter& parameter : team.params) parameters.push_back(json_of(parameter));
  return {{"name", team.name}, {"about", team.about}, {"params", std::move(parameters)}};
}

}  // namespace

TextBlocks teams_text() {
  std::vector<std::vector<std::string>> rows;
  for (const Entry& team : strategies::all_strategies()) {
    rows.push_back({std::string(team.name), std::string(team.about)});
  }
  return {"Teams (autoref teams NAME lists a team's parameters):\n\n",
          TextTable{std::move(rows), kAllLeft}};
}

std::string teams_json() {
  Json teams = Json::array();
  for (const Entry& team : strategies::all_strategies()) teams.push_back(json_of(team));
  return json_text({{"teams", std::move(teams)}}) + "\n";
}

TextBlocks team_text(const Entry& team) {
  const std::string head = fmt::format("{}: {}\n\n", team.name, team.about);
  if (team.params.empty()) return {head + "This team has no parameters.\n"};
  std::vector<std::vector<std::string>> rows = {{"parameter", "unit", "default", "range", ""}};
  for (const Parameter& parameter : team.params) rows.push_back(cells_of(parameter));
  return {head, TextTable{std::move(rows), kAllLeft},
          fmt::format("\nIn a scenario: {{ strategy: {}, params: {{ {}: {} }} }}\n", team.name,
                      team.params.front().name, team.params.front().standard)};
}

std::string team_json(const Entry& team) { return json_text(json_of(team)) + "\n"; }

}  // namespace autoref::runner
