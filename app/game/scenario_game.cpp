#include "app/game/scenario_game.hpp"

#include <fmt/format.h>

#include <variant>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/named_files.hpp"
#include "io/errors.hpp"

namespace autoref::app {

game::GameSettings game_in(const std::string& file, const std::string& seed,
                           const game::Assignments& assignments) {
  experiments::Scenario scenario = experiments::read_scenario(file, assignments);
  auto* game = std::get_if<game::GameSettings>(&scenario.content);
  if (game == nullptr) {
    throw io::InputError(
        {file}, "kind",
        fmt::format("this file is of kind {}, not a game; run it with: autoref {} {}",
                    experiments::kind_of(scenario), experiments::verb_of(scenario), file));
  }
  if (!seed.empty()) game::locate_errors("--seed", [&] { game::set_by_path(*game, "seed", seed); });
  return *game;
}

std::vector<std::string> inputs_of(const std::string& file, const std::string& commands,
                                   const game::Assignments& assignments) {
  std::vector<std::string> inputs;
  if (!file.empty()) {
    inputs = game::settings_files_in(file);
    inputs.push_back(file);
  }
  if (!commands.empty()) inputs.push_back(commands);
  for (const game::Assignment& assignment : assignments) {
    if (game::is_settings_file(assignment.value)) inputs.push_back(assignment.value);
  }
  return inputs;
}

}  // namespace autoref::app
