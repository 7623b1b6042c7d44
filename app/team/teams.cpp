#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_line.hpp"
#include "app/team/teams_report.hpp"
#include "io/errors.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"

namespace autoref::app {
namespace {

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

}  // namespace

int teams_verb(const TeamsArguments& arguments) {
  fmt::print("{}", text_for(arguments));
  return io::kDone;
}

void add_teams_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("teams", "List the teams, or the parameters of one.");
  auto arguments = std::make_shared<TeamsArguments>();
  verb->add_option("TEAM", arguments->name, "Name of a team. Default: list all teams.");
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->footer("Example:\n  autoref teams basic");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return teams_verb(*arguments); }; });
}

}  // namespace autoref::app
