#include "app/team/teams_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::app {
namespace {

using strategies::Entry;
using strategies::Tunable;

const std::vector<io::Align> kAllLeft(5, io::Align::kLeft);

// "1" for fractions and counts.
std::string_view unit_or_one(const Tunable& tunable) {
  const std::string_view unit = unit_of(tunable.name);
  return unit.empty() ? "1" : unit;
}

std::vector<std::string> cells_of(const Tunable& tunable) {
  return {std::string(tunable.name), std::string(unit_or_one(tunable)),
          fmt::format("{}", tunable.standard),
          fmt::format("{} to {}", tunable.range.low, tunable.range.high),
          std::string(tunable.about)};
}

io::Json json_of(const Tunable& tunable) {
  return {{"name", tunable.name},        {"unit", unit_or_one(tunable)},
          {"default", tunable.standard}, {"least", tunable.range.low},
          {"most", tunable.range.high},  {"about", tunable.about}};
}

io::Json json_of(const Entry& team) {
  io::Json parameters = io::Json::array();
  for (const Tunable& tunable : team.params) parameters.push_back(json_of(tunable));
  return {{"name", team.name}, {"about", team.about}, {"params", std::move(parameters)}};
}

}  // namespace

io::TextBlocks teams_text() {
  std::vector<std::vector<std::string>> rows;
  for (const Entry& team : strategies::all_strategies()) {
    rows.push_back({std::string(team.name), std::string(team.about)});
  }
  return {"Teams (autoref teams NAME lists a team's parameters):\n\n",
          io::TextTable{std::move(rows), kAllLeft}};
}

std::string teams_json() {
  io::Json teams = io::Json::array();
  for (const Entry& team : strategies::all_strategies()) teams.push_back(json_of(team));
  return io::json_text({{"teams", std::move(teams)}}) + "\n";
}

io::TextBlocks team_text(const Entry& team) {
  const std::string head = fmt::format("{}: {}\n\n", team.name, team.about);
  if (team.params.empty()) return {head + "This team has no parameters.\n"};
  std::vector<std::vector<std::string>> rows = {{"parameter", "unit", "default", "range", ""}};
  for (const Tunable& tunable : team.params) rows.push_back(cells_of(tunable));
  return {head, io::TextTable{std::move(rows), kAllLeft},
          fmt::format("\nIn a scenario: {{ strategy: {}, params: {{ {}: {} }} }}\n", team.name,
                      team.params.front().name, team.params.front().standard)};
}

std::string team_json(const Entry& team) { return io::json_text(json_of(team)) + "\n"; }

}  // namespace autoref::app
