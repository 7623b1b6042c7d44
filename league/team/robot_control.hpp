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

// Adds the commands of `control`. Global velocities are rotated into the robots' frames by
// `headings`. Kicks at an angle above 0 become chip kicks, whatever the angle. Throws TeamFault for
// wheel velocities and for angles that are not from 0 to 90 degrees, and like OutputBuilder.
void add_commands(const simulation::RobotControl& control, const Headings& headings,
                  OutputBuilder& builder);

}  // namespace autoref::league
