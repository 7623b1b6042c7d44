#include <CLI/CLI.hpp>

#include "app/command_line.hpp"

namespace autoref::app {

void add_team_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("team", "Teams that are programs in any language.");
  verb->require_subcommand(1);
  add_team_new_verb(*verb, chosen);
  add_team_play_verb(*verb, chosen);
  add_team_check_verb(*verb, chosen);
}

}  // namespace autoref::app
