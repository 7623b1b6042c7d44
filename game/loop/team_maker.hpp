// Creates a game's teams.
#pragma once

#include <functional>
#include <memory>

#include "game/loop/configuration.hpp"
#include "strategies/strategy.hpp"

namespace autoref::game {

// Creates a team. Throws std::invalid_argument if there is no such team.
using TeamMaker = std::function<std::unique_ptr<strategies::Strategy>(
    const TeamConfiguration& team, const strategies::TeamContext& context)>;

// The team that its strategy names (strategies/registry.hpp).
std::unique_ptr<strategies::Strategy> make_registered_team(const TeamConfiguration& team,
                                                           const strategies::TeamContext& context);

}  // namespace autoref::game
