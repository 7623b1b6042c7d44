// The simulated robots' reports to network teams, and the robot data to which commands refer.
#pragma once

#include <array>
#include <bitset>

#include "game/loop/game_configuration.hpp"
#include "league/simulator/grsim_packet.hpp"
#include "live/simulator/command_slots.hpp"
#include "sim/world.hpp"

namespace autoref::live {

// The reports of a side's robots.
struct RobotReports {
  // Whether the ball is in the dribbler zone, by robot number.
  std::bitset<kMaxRobots> ball_contact;
  std::array<league::GrsimStatus, kMaxRobots> status{};
};

// The reports after a step of the simulation.
PerSide<RobotReports> reports_of(const game::GameConfiguration& game, const sim::World& world);

// The wheels of a team's robots.
std::array<league::WheelPositions, kMaxRobots> wheels_of(const game::TeamConfiguration& team);

// Sets the headings of a side's robots in the frame of vision.
void headings_of(const sim::WorldState& world, Side side, bool blue_on_positive_half,
                 SideState& state);

}  // namespace autoref::live
