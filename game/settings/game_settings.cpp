#include "game/settings/game_settings.hpp"

#include <fmt/format.h>
#include <stdexcept>

#include "game/settings/robot_types.hpp"
#include "sim/presets.hpp"

namespace autoref::game {
namespace {

RuleBook book_of(const std::string& name) {
  const std::optional<RuleBook> rules = find_rule_book(name);
  if (!rules) throw std::invalid_argument(fmt::format("unknown rule book '{}'", name));
  return *rules;
}

TeamConfiguration resolved(const GameSettings& game, const TeamSettings& team,
                           std::string_view path) {
  TeamConfiguration configuration{team.strategy, team.params, spec_of(game, team, path).robots};
  if (!team.program.command.empty()) configuration.program = team.program;
  configuration.laws =
      team.laws == kEnforcedOnly ? std::nullopt : std::optional(book_of(team.laws));
  configuration.on_network = team.program.command.empty() && team.strategy == kNetworkStrategy;
  return configuration;
}

}  // namespace

std::string name_of(const TeamSettings& team) {
  return team.program.command.empty() ? team.strategy : program_name(team.program.command);
}

void choose_rules(const std::string& book, GameSettings& game) {
  game.match.rules = book_of(book);
  const GameSetup setup = *find_game_setup(book);
  game.match.half_s = setup.half_s;
  game.field = setup.field;
  sim::apply_kicker_preset(setup.kickers_and_dribblers, game.robot.kicker);
  sim::apply_dribbler_preset(setup.kickers_and_dribblers, game.robot.dribbler);
  game.sim.latency_error_s = setup.latency_error_s;
  game.a.robots = game.b.robots = setup.robots;
}

GameConfiguration resolved(const GameSettings& settings) {
  return {resolved(settings, settings.a, "teams.a"),
          resolved(settings, settings.b, "teams.b"),
          settings.match,
          settings.field,
          settings.sim,
          settings.seed,
          settings.start,
          settings.scene};
}

}  // namespace autoref::game
