// A team that is commanded over the network.
#pragma once

#include <string>

#include "soccer/robot_command.hpp"
#include "strategies/strategy.hpp"

namespace autoref::live {

// What a team on the network does in the next step.
struct NetworkInput {
  TeamCommands commands{};
  std::string fault;  // empty: none
};

// Plays its input, which the game's loop sets before each step.
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
