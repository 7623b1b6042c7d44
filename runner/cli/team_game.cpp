#include "runner/cli/team_game.hpp"

#include <CLI/CLI.hpp>

#include "runner/settings/assignments.hpp"
#include "runner/settings/fields.hpp"
#include "runner/settings/resolved.hpp"

namespace autoref::runner {

void add_program_argument(CLI::App& verb, std::string& command) {
  verb.add_option("COMMAND", command,
                  "The program and its arguments, in quotes: 'python3 my_team.py'.")
      ->required();
}

GameSettings team_game(const std::string& command, const std::string& opponent, double half_s,
                       const std::vector<std::string>& sets) {
  GameSettings game;
  choose_rules("2026-b", game);
  game.match.half_s = half_s;
  blame("the command of the team", [&] { set_by_path(game, "a.command", command); });
  blame("--opponent", [&] { set_by_path(game, "b.strategy", opponent); });
  for (const Assignment& assignment : assignments_in(sets))
    blame("--set", [&] { set_by_path(game, assignment.path, assignment.value); });
  blame("--set", [&] { check_game(game); });
  return game;
}

}  // namespace autoref::runner
