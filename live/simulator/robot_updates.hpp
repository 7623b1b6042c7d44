// Robots' limits that programs on the network set before a game.
#pragma once

#include <bitset>
#include <mutex>
#include <vector>

#include "game/loop/configuration.hpp"
#include "game/team_programs/changed_robot.hpp"
#include "league/simulator/simulator_command.hpp"

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

}  // namespace autoref::live
