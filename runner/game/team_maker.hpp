// Creates a game's teams.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "strategies/strategy.hpp"

namespace autoref::runner {

// Creates the team of that name. Throws std::invalid_argument if the name is unknown.
using TeamMaker = std::function<std::unique_ptr<strategies::Strategy>(
    const std::string& name, const strategies::TeamContext& context)>;

// The teams of strategies/registry.hpp.
std::unique_ptr<strategies::Strategy> make_registered_team(const std::string& name,
                                                           const strategies::TeamContext& context);

}  // namespace autoref::runner
