// The interface of a team: from its view of the game to its robots' commands, once per frame.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "soccer/abilities.hpp"
#include "soccer/field.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/team_requests.hpp"
#include "soccer/team_view.hpp"

namespace autoref::strategies {

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
