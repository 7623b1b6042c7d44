// The newest command of each robot, passed from the network's thread to the game's thread, and the
// team that plays these commands.
#pragma once

#include <array>
#include <bitset>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "league/simulator/command_update.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/side.hpp"
#include "strategies/strategy.hpp"

namespace autoref::live {

// The state to which a side's commands refer.
struct SideState {
  std::array<Vec2, kMaxRobots> headings{};  // robots' headings in the frame of vision, by number
  std::array<league::WheelPositions, kMaxRobots> wheels{};
};

class CommandSlots {
 public:
  using Clock = std::chrono::steady_clock;

  // Commands older than `lapse_frames` frames lapse, and their robots stop.
  explicit CommandSlots(int lapse_frames) : lapse_frames_(lapse_frames) {}

  // Called in the network's thread: accepts a packet's updates.
  void add(Side side, const std::vector<league::CommandUpdate>& updates);

  // The number of packets that each side has sent so far.
  PerSide<std::int64_t> packets() const;

  // Waits until each side in `is_awaited` has sent more packets than in `before`. Returns false if
  // that has not happened by the deadline.
  bool wait(const PerSide<std::int64_t>& before, const PerSide<bool>& is_awaited,
            Clock::time_point deadline);

  // The commands of a side for the step after `frame`, as transmitted() sends them to robots.
  // Commands that have arrived since the last call are attributed to `frame`; those that have
  // lapsed are dropped.
  TeamCommands collect_commands(Side side, std::int64_t frame, const SideState& state);

 private:
  struct Slot {
    league::CommandUpdate held;
    bool is_new = false;
    std::int64_t frame = 0;  // frame of the newest update
    bool is_held = false;
  };

  int lapse_frames_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  bool is_waiting_ = false;
  PerSide<std::array<Slot, kMaxRobots>> slots_;
  PerSide<std::int64_t> packets_;
};

// The input for a team on the network in the next step.
struct NetworkInput {
  TeamCommands commands{};
  std::string fault;  // empty: none
};

// A team that is commanded over the network: plays its input, which the game's loop sets before
// each step.
class NetworkTeam final : public strategies::Strategy {
 public:
  explicit NetworkTeam(const NetworkInput& input) : input_(&input) {}
  void decide(const TeamView& /*view*/, TeamCommands& commands) override {
    if (!input_->fault.empty()) throw strategies::StrategyFault(input_->fault);
    commands = input_->commands;
  }

 private:
  const NetworkInput* input_;
};

}  // namespace autoref::live
