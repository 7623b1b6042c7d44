// From teleports in the frame of vision to changes of the simulated world.
#pragma once

#include <optional>

#include "league/simulator/teleport.hpp"
#include "runner/team_programs/world_change.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::runner {

// The change; what the teleport leaves out stays as it is in `world`. Positions beyond the walls
// are moved inside. nullopt if a robot that is off the field is not placed completely.
std::optional<WorldChange> change_of(const league::Teleport& teleport, const sim::WorldState& world,
                                     const Field& field, bool blue_on_positive_half);

}  // namespace autoref::runner
