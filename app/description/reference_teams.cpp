// The reference page of compiled-in teams and their parameters.
#include <fmt/format.h>

#include "app/description/reference_pages.hpp"
#include "soccer/parameters.hpp"
#include "strategies/registry.hpp"

namespace autoref::app {
namespace {

std::string parameters_table(const strategies::Entry& team) {
  if (team.params.empty()) return "This team has no parameters.\n\n";
  std::vector<std::vector<std::string>> rows = {{"parameter", "default", "range", "meaning"}};
  for (const strategies::Tunable& tunable : team.params) {
    const std::string_view unit = unit_of(tunable.name);
    rows.push_back({code_span(std::string(tunable.name)),
                    fmt::format("{}{}{}", tunable.standard, unit.empty() ? "" : " ", unit),
                    fmt::format("{} to {}", tunable.range.low, tunable.range.high),
                    std::string(tunable.about)});
  }
  return reference_table(rows);
}

}  // namespace

std::string team_parameters_page() {
  std::string page = reference_head("Teams and their parameters", "teams") +
                     "The teams that are compiled in. `--set a.params.NAME=NUMBER` sets a "
                     "parameter of team a; in a scenario it is "
                     "`a: { strategy: basic, params: { NAME: NUMBER } }`.\n\n";
  for (const strategies::Entry& team : strategies::all_strategies())
    page += fmt::format("## {}\n\n{}\n\n", team.name, team.about) + parameters_table(team);
  page.pop_back();
  return page;
}

}  // namespace autoref::app
