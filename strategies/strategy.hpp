// The interface of a team: from its view of the game to its robots' commands, once per frame.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "soccer/field.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/team_requests.hpp"
#include "soccer/team_view.hpp"

namespace autoref::strategies {

// What one of a team's robots can do, including its handicap. The defaults are the paper's robots.
struct Abilities {
  double speed_mps = 3.0;
  double acceleration_mps2 = 3.0;
  double braking_mps2 = 5.0;
  double kick_mps = 8.0;
  double chip_mps = 5.5;
};

// What a team knows before the game.
struct TeamContext {
  Field field;
  RuleBook rules;
  double frame_rate_hz = 60;
  RandomStream random{0};                    // this team's stream; the only randomness allowed
  std::map<std::string, double> params;      // the team's parameters by name
  std::array<Abilities, kMaxRobots> robots;  // the team's own robots, by number
};

class Strategy {
 public:
  virtual ~Strategy() = default;

  // Decides on one view. `commands` is all zero on entry, so a robot without a command stands
  // still. A strategy may keep state, but must not read a clock or share anything with other games.
  virtual void decide(const TeamView& view, TeamCommands& commands) = 0;

  virtual TeamRequests requests() const { return {}; }
};

}  // namespace autoref::strategies
