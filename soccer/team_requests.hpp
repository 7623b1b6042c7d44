// What a team may ask of the referee.
#pragma once

namespace autoref {

struct TeamRequests {
  int keeper = 0;  // number of the robot that acts as goalkeeper
};

}  // namespace autoref
