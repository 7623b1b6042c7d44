// Robots' commands in the league's simulation protocol.
#pragma once

#include <array>

#include "league/messages/simulation.pb.h"
#include "league/team/output_builder.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::league {

// Headings of a team's robots in the frame of vision, by number.
using Headings = std::array<Vec2, kMaxRobots>;

// Adds the commands of `control` (league/simulator/command_update.hpp). Global velocities are
// rotated into the robots' frames by `headings`. Throws TeamFault for wheel velocities and for what
// updates_of() reports as an error, and like OutputBuilder.
void add_commands(const simulation::RobotControl& control, const Headings& headings,
                  OutputBuilder& builder);

}  // namespace autoref::league
