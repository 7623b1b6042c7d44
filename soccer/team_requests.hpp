// What a team may request from the referee.
#pragma once

#include <optional>

namespace autoref {

struct TeamRequests {
  int keeper = 0;             // number of the robot that acts as keeper; -1: unknown
  std::optional<int> leaves;  // the robot to remove first after a card
  bool timeout = false;       // requested as soon as play is stopped, for as long as it is set
};

}  // namespace autoref
