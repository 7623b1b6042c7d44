// Measures how long each robot has continuously met a condition.
#pragma once

#include <map>

#include "soccer/side.hpp"

namespace autoref::judge::ground_truth {

class Lasting {
 public:
  // Call for every robot in every frame. Returns how long `does` has been true, or a negative value
  // if it is false.
  double lasts_s(RobotId id, bool does, double time_s) {
    if (does) return time_s - since_s_.try_emplace(id, time_s).first->second;
    since_s_.erase(id);
    return -1.0;
  }
  void clear() { since_s_.clear(); }

 private:
  std::map<RobotId, double> since_s_;
};

}  // namespace autoref::judge::ground_truth
