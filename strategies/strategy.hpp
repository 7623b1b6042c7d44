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
#include "soccer/side.hpp"
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
  Side side = Side::kWest;                   // west plays in yellow
  int robot_count = kMaxRobots;
  double latency_s = 0;           // from a frame until a command based on it moves a robot
  std::uint64_t random_seed = 0;  // RandomStream(random_seed) is `random`
};

class Strategy {
 public:
  virtual ~Strategy() = default;

  // Called for both teams before either decides, with the view to decide on: a team that thinks in
  // another process begins here.
  virtual void prepare(const TeamView& /*view*/) {}

  // Decides on one view. `commands` is all zero on entry, so a robot without a command stands
  // still. A strategy may keep state, but must not read a clock or share anything with other games.
  virtual void decide(const TeamView& view, TeamCommands& commands) = 0;

  virtual TeamRequests requests() const { return {}; }
};

}  // namespace autoref::strategies
