// Reports robots that violate a rule for longer than its grace period.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "judge/truth/scene.hpp"

namespace autoref::judge::ground_truth {

// Detects one kind of offence, at most once per robot and phase. Each restart or stop starts a
// phase.
class GraceTimer {
 public:
  GraceTimer(std::string_view name, double margin) : name_(name), margin_(margin) {}

  // Call for every robot in every frame in which the rule applies. `excess` is how far the robot is
  // beyond the threshold, in the unit of the margin; it commits an offence if it stays beyond for
  // longer than `grace_s`. Each command starts a phase.
  void watch(const Scene& scene, RobotId id, const sim::RobotState& robot, double excess,
             double grace_s, TrueEvents& all);

 private:
  // Start of the current offence, and the phase in which it was reported.
  struct Watch {
    std::optional<double> since_s;
    int reported = -1;
    bool is_over(double time_s, bool offends, double grace_s, int spell);
  };
  struct Watches {
    int spell = -1;  // current phase
    Watch nearly;
    Watch truly;
    Watch clearly;
  };

  std::string_view name_;
  double margin_;
  PerSide<std::map<int, Watches>> watches_;  // by number
};

}  // namespace autoref::judge::ground_truth
