#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_line.hpp"
#include "app/team/team_check_report.hpp"
#include "app/team/team_game.hpp"
#include "game/settings/resolved.hpp"
#include "game/team_programs/team_check.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

constexpr double kCheckedHalf_s = 5;

}  // namespace

int team_check_verb(const TeamCheckArguments& arguments) {
  const game::TeamCheck check = game::check_team(
      game::resolved(team_game(arguments.command, "basic", kCheckedHalf_s, arguments.sets)));
  fmt::print("{}{}", arguments.json ? json_of(check) : text_of(check), arguments.json ? "\n" : "");
  return check.fault.empty() ? io::kDone : io::kTooManyVoid;
}

void add_team_check_verb(CLI::App& team, Chosen& chosen) {
  CLI::App* verb = team.add_subcommand("check", "Try out a team that is a program.");
  auto arguments = std::make_shared<TeamCheckArguments>();
  add_program_argument(*verb, arguments->command);
  add_set_option(*verb, arguments->sets);
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->footer(
      "Plays two halves of five seconds against basic, twice with the same seed. Prints what the\n"
      "program asks for, how fast it answers, whether it repeats its commands, and what is "
      "wrong.\n\n"
      "Example:\n  autoref team check 'python3 my_team.py' --set a.directory=teams");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return team_check_verb(*arguments); }; });
}

}  // namespace autoref::app
