#include "app/team/team_game.hpp"

#include <CLI/CLI.hpp>

#include "game/settings/assignments.hpp"
#include "game/settings/fields.hpp"

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
  game::locate_errors("the command of the team",
                      [&] { game::set_by_path(game, "a.command", command); });
  game::locate_errors("--opponent", [&] { game::set_by_path(game, "b.strategy", opponent); });
  for (const game::Assignment& assignment : game::assignments_in(sets))
    game::locate_errors("--set",
                        [&] { game::set_by_path(game, assignment.path, assignment.value); });
  game::locate_errors("--set", [&] { game::check_game(game); });
  return game;
}

}  // namespace autoref::app
