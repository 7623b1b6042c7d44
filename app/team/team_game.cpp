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
  game::blame("the command of the team", [&] { game::set_by_path(game, "a.command", command); });
  game::blame("--opponent", [&] { game::set_by_path(game, "b.strategy", opponent); });
  for (const game::Assignment& assignment : game::assignments_in(sets))
    game::blame("--set", [&] { game::set_by_path(game, assignment.path, assignment.value); });
  game::blame("--set", [&] { game::check_game(game); });
  return game;
}

}  // namespace autoref::app
