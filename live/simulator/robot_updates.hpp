// What programs on the network change besides commands: robots' limits before a game, and the world
// by teleports.
#pragma once

#include <bitset>
#include <mutex>
#include <optional>
#include <vector>

#include "game/loop/game_configuration.hpp"
#include "game/team_programs/world_change.hpp"
#include "league/simulator/command_update.hpp"
#include "league/simulator/simulator_command.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::live {

class RobotUpdates {
 public:
  explicit RobotUpdates(const game::GameConfiguration& game) : game_(game) {}

  // In the network's thread. What cannot be done is added to `errors`. Codes: ROBOT_SPECS (a number
  // is out of range), GAME_BEGUN. A wheel's acceleration changes in proportion to the robot's.
  void add(const std::vector<league::SpecUpdate>& updates,
           std::vector<league::PacketError>& errors);

  // In the game's thread, when the game begins: the robots that differ, each once. Later changes
  // are refused.
  std::vector<game::ChangedRobot> close();

 private:
  void add_one(const league::SpecUpdate& update, std::vector<league::PacketError>& errors);

  std::mutex mutex_;
  game::GameConfiguration game_;
  PerSide<std::bitset<kMaxRobots>> is_changed_;
  bool is_closed_ = false;
};

// The change of the simulated world by a teleport in the frame of vision; what the teleport leaves
// out stays as it is in `world`. Positions beyond the walls are moved inside. nullopt if a robot
// that is off the field is not placed completely.
std::optional<game::WorldChange> change_of(const league::Teleport& teleport,
                                           const sim::WorldState& world, const Field& field,
                                           bool blue_on_positive_half);

}  // namespace autoref::live
