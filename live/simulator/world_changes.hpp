// From teleports in the frame of vision to changes of the simulated world.
#pragma once

#include <optional>

#include "game/team_programs/world_change.hpp"
#include "league/simulator/teleport.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::live {

// The change; what the teleport leaves out stays as it is in `world`. Positions beyond the walls
// are moved inside. nullopt if a robot that is off the field is not placed completely.
std::optional<game::WorldChange> change_of(const league::Teleport& teleport,
                                           const sim::WorldState& world, const Field& field,
                                           bool blue_on_positive_half);

}  // namespace autoref::live
