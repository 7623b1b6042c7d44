// Decides when a non-stopping violation of the 2026 rules is raised: when it starts, and every 2 s
// while it lasts. After it has ended, the next one counts at once.
#pragma once

#include <map>

#include "judge/truth/team_foul.hpp"

namespace autoref::judge::ground_truth {

class NonStopping {
 public:
  // Call in each frame in which a robot commits the violation. Returns whether it is raised.
  bool is_raised(const Scene& scene, RobotId id) {
    const auto known = raised_s_.find(id);
    if (known != raised_s_.end() && !has_passed(scene, known->second, kRaisedAgain_s)) return false;
    raised_s_[id] = scene.time_s;
    return true;
  }
  // Ends the robot's violation, if any.
  void end(RobotId id) { raised_s_.erase(id); }
  bool lasts(RobotId id) const { return raised_s_.contains(id); }
  void clear() { raised_s_.clear(); }

 private:
  // 2026 rules, "Non-Stopping Fouls".
  static constexpr double kRaisedAgain_s = 2_s;
  std::map<RobotId, double> raised_s_;
};

}  // namespace autoref::judge::ground_truth
