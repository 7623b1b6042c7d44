#include "game/loop/team_maker.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "strategies/registry.hpp"

namespace autoref::game {

std::unique_ptr<strategies::Strategy> make_registered_team(const TeamConfiguration& team,
                                                           const strategies::TeamContext& context) {
  if (team.on_network)
    throw std::invalid_argument("a team on the network plays only in autoref live");
  const strategies::Entry* entry = strategies::find_strategy(team.strategy);
  if (entry == nullptr)
    throw std::invalid_argument(fmt::format("unknown strategy '{}'", team.strategy));
  return entry->make(context);
}

}  // namespace autoref::game
