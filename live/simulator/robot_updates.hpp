// Changes other than commands that programs on the network request: limits of robots before a game,
// and teleports.
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

  // Called in the network's thread. Updates that cannot be applied are added to `errors`, with the
  // codes ROBOT_SPECS (a value is out of range) and GAME_BEGUN. A wheel's acceleration changes in
  // proportion to the robot's.
  void add(const std::vector<league::SpecUpdate>& updates,
           std::vector<league::PacketError>& errors);

  // Called in the game's thread when the game begins: returns each changed robot once. Changes
  // after this call are refused.
  std::vector<game::ChangedRobot> close();

 private:
  void add_one(const league::SpecUpdate& update, std::vector<league::PacketError>& errors);

  std::mutex mutex_;
  game::GameConfiguration game_;
  PerSide<std::bitset<kMaxRobots>> is_changed_;
  bool is_closed_ = false;
};

// The change of the simulated world that a teleport requests. The teleport is in the coordinates of
// vision. Values missing from the teleport stay as they are in `world`. Positions beyond the walls
// are moved inside. Returns nullopt if the teleport of a robot off the field is incomplete.
std::optional<game::WorldChange> change_of(const league::Teleport& teleport,
                                           const sim::WorldState& world, const Field& field,
                                           bool blue_on_positive_half);

}  // namespace autoref::live
