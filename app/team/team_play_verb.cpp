#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "app/game/play_one.hpp"
#include "app/shared_options.hpp"
#include "app/team/team_game.hpp"
#include "app/verbs.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

struct TeamPlayArguments {
  std::string command;
  std::string opponent = "dummy";
  std::vector<std::string> sets;  // "key=value"
  GameOutput output;
};

int team_play_verb(const TeamPlayArguments& arguments) {
  const game::GameConfiguration game =
      game::resolved(team_game(arguments.command, arguments.opponent, 120, arguments.sets));
  const game::GameRecord record = play_one(game, arguments.output, {});
  return record.status == game::Status::kVoid ? io::kTooManyVoid : io::kDone;
}

}  // namespace

void add_team_play_verb(CLI::App& team, Chosen& chosen) {
  CLI::App* verb = team.add_subcommand("play", "Play a game with a team that is a program.");
  auto arguments = std::make_shared<TeamPlayArguments>();
  add_program_argument(*verb, arguments->command);
  verb->add_option("--opponent", arguments->opponent, "A team that `autoref show teams` lists.")
      ->type_name("TEAM")
      ->capture_default_str();
  add_set_option(*verb, arguments->sets);
  add_output_options(*verb, arguments->output);
  add_speed_option(*verb, arguments->output);
  verb->footer(
      "Two halves of two minutes by the rules of 2026.\n\n"
      "Example:\n  autoref team play 'python3 my_team.py' --opponent basic --view game.html");
  choose(*verb, chosen, arguments, team_play_verb);
}

}  // namespace autoref::app
