#include "app/show/teams_verb.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"
#include "io/table.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"

namespace autoref::app {
namespace {

struct TeamsArguments {
  std::string name;  // empty: list the teams
  bool json = false;
};

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

const strategies::Entry& team_named(const std::string& name) {
  if (const strategies::Entry* team = strategies::find_strategy(name)) return *team;
  std::vector<std::string> known;
  for (const strategies::Entry& team : strategies::all_strategies()) known.emplace_back(team.name);
  const std::string nearest = io::suggestion(name, known);
  throw io::InputError({}, "",
                       fmt::format("unknown team '{}'{} Known here: {}", name,
                                   nearest.empty() ? "." : nearest, io::listed(known)));
}

std::string text_for(const TeamsArguments& arguments) {
  const auto shown = [](const io::TextBlocks& blocks) {
    return io::text_of(blocks, io::text_width(stdout));
  };
  if (arguments.name.empty()) return arguments.json ? teams_json() : shown(teams_text());
  const strategies::Entry& team = team_named(arguments.name);
  return arguments.json ? team_json(team) : shown(team_text(team));
}

int teams_verb(const TeamsArguments& arguments) {
  fmt::print("{}", text_for(arguments));
  return io::kDone;
}

}  // namespace

io::TextBlocks teams_text() {
  std::vector<std::vector<std::string>> rows;
  for (const Entry& team : strategies::all_strategies()) {
    rows.push_back({std::string(team.name), std::string(team.about)});
  }
  return {"Teams (autoref show teams NAME lists a team's parameters):\n\n",
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

void add_teams_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("teams", "List the teams, or the parameters of one.");
  auto arguments = std::make_shared<TeamsArguments>();
  verb->add_option("TEAM", arguments->name, "Name of a team. Default: list all teams.");
  add_json_flag(*verb, arguments->json);
  verb->footer("Example:\n  autoref show teams basic");
  choose(*verb, chosen, arguments, teams_verb);
}

}  // namespace autoref::app
