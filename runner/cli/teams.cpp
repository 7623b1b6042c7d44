#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "runner/cli/command_line.hpp"
#include "runner/cli/teams_report.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/terminal.hpp"
#include "runner/io/words.hpp"

namespace autoref::runner {
namespace {

const strategies::Entry& team_named(const std::string& name) {
  if (const strategies::Entry* team = strategies::find_strategy(name)) return *team;
  std::vector<std::string> known;
  for (const strategies::Entry& team : strategies::all_strategies()) known.emplace_back(team.name);
  const std::string nearest = suggestion(name, known);
  throw InputError({}, "",
                   fmt::format("unknown team '{}'{} Known here: {}", name,
                               nearest.empty() ? "." : nearest, listed(known)));
}

std::string text_for(const TeamsArguments& arguments) {
  const auto shown = [](const TextBlocks& blocks) { return text_of(blocks, text_width(stdout)); };
  if (arguments.name.empty()) return arguments.json ? teams_json() : shown(teams_text());
  const strategies::Entry& team = team_named(arguments.name);
  return arguments.json ? team_json(team) : shown(team_text(team));
}

}  // namespace

int teams_verb(const TeamsArguments& arguments) {
  fmt::print("{}", text_for(arguments));
  return kDone;
}

void add_teams_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("teams", "List the teams, or the parameters of one.");
  auto arguments = std::make_shared<TeamsArguments>();
  verb->add_option("TEAM", arguments->name, "Name of a team. Default: list all teams.");
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->footer("Example:\n  autoref teams basic");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return teams_verb(*arguments); }; });
}

}  // namespace autoref::runner
