// What a team may ask of the referee.
#pragma once

#include <optional>

namespace autoref {

struct TeamRequests {
  int keeper = 0;             // number of the robot that acts as goalkeeper
  std::optional<int> leaves;  // the robot that leaves first after a card
  bool timeout = false;       // wanted as soon as play is stopped, and for as long
};

}  // namespace autoref
