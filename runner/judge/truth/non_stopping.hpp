// When a violation of the rules of 2026 that lets play go on is raised: as it begins, and while it
// lasts, again 2 s after it was raised. Once it has ended, the next one counts at once.
#pragma once

#include <map>

#include "runner/judge/truth/team_foul.hpp"

namespace autoref::runner::ground_truth {

class NonStopping {
 public:
  // A robot commits it in this frame; whether it is raised.
  bool is_raised(const Scene& scene, RobotId id) {
    const auto known = raised_s_.find(id);
    if (known != raised_s_.end() && !has_passed(scene, known->second, kRaisedAgain_s)) return false;
    raised_s_[id] = scene.time_s;
    return true;
  }
  // The robot's violation, if it has one, is over.
  void end(RobotId id) { raised_s_.erase(id); }
  bool lasts(RobotId id) const { return raised_s_.contains(id); }
  void clear() { raised_s_.clear(); }

 private:
  // Rules of 2026, "Non-Stopping Fouls".
  static constexpr double kRaisedAgain_s = 2_s;
  std::map<RobotId, double> raised_s_;
};

}  // namespace autoref::runner::ground_truth
