#include "app/team/team_play.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_line.hpp"
#include "app/game/play_one.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::app {

void add_program_argument(CLI::App& verb, std::string& command) {
  verb.add_option("COMMAND", command,
                  "The program and its arguments, in quotes: 'python3 my_team.py'.")
      ->required();
}

game::GameSettings team_game(const std::string& command, const std::string& opponent, double half_s,
                             const std::vector<std::string>& sets) {
  game::GameSettings game;
  game::choose_rules("2026-b", game);
  game.match.half_s = half_s;
  game::blame("the command of the team", [&] { game::set_by_path(game, "a.command", command); });
  game::blame("--opponent", [&] { game::set_by_path(game, "b.strategy", opponent); });
  for (const game::Assignment& assignment : game::assignments_in(sets))
    game::blame("--set", [&] { game::set_by_path(game, assignment.path, assignment.value); });
  game::blame("--set", [&] { game::check_game(game); });
  return game;
}

int team_play_verb(const TeamPlayArguments& arguments) {
  const game::GameConfiguration game =
      game::resolved(team_game(arguments.command, arguments.opponent, 120, arguments.sets));
  const game::GameRecord record = play_one(game, arguments.output, {});
  return record.status == game::Status::kVoid ? io::kTooManyVoid : io::kDone;
}

void add_team_play_verb(CLI::App& team, Chosen& chosen) {
  CLI::App* verb = team.add_subcommand("play", "Play a game with a team that is a program.");
  auto arguments = std::make_shared<TeamPlayArguments>();
  add_program_argument(*verb, arguments->command);
  verb->add_option("--opponent", arguments->opponent, "A team that `autoref teams` lists.")
      ->type_name("TEAM")
      ->capture_default_str();
  add_set_option(*verb, arguments->sets);
  add_output_options(*verb, arguments->output);
  add_speed_option(*verb, arguments->output);
  verb->footer(
      "Two halves of two minutes by the rules of 2026.\n\n"
      "Example:\n  autoref team play 'python3 my_team.py' --opponent basic --view game.html");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return team_play_verb(*arguments); }; });
}

}  // namespace autoref::app
