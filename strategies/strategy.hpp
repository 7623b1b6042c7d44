// What a team is: from its view of the game to its robots' orders, once per frame.
#pragma once

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

// What a team knows before the game.
struct Briefing {
  Field field;
  RuleBook rules;
  double frame_rate_hz = 60;
  RandomStream random{0};                // the side's own; the only source of chance allowed
  std::map<std::string, double> params;  // the team's tunables by name
};

class Strategy {
 public:
  virtual ~Strategy() = default;

  // Decides on one view. `orders` comes in all zero: a robot that gets no order stands still. A
  // strategy may keep memory, but reads no clock and shares nothing with other games.
  virtual void decide(const TeamView& view, TeamOrders& orders) = 0;

  virtual TeamRequests requests() const { return {}; }
};

}  // namespace autoref::strategies
