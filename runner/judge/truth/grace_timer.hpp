// How long robots have been doing what they may do only for a while.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "runner/judge/truth/scene.hpp"

namespace autoref::runner::ground_truth {

// Watches one kind of offence of each robot, once per robot and spell: a restart or stop.
class GraceTimer {
 public:
  GraceTimer(std::string_view name, double margin) : name_(name), margin_(margin) {}

  // To be called for every robot in every frame in which the rule holds. `excess` is how far the
  // robot is beyond the threshold, in the margin's unit; it offends once it has been for longer
  // than `grace_s`. Each command begins a spell.
  void watch(const Scene& scene, RobotId id, const sim::RobotState& robot, double excess,
             double grace_s, TrueEvents& all);

 private:
  // Since when the robot has been so far beyond the threshold, and in which spell it was told.
  struct Watch {
    std::optional<double> since_s;
    int reported = -1;
    bool is_over(double time_s, bool offends, double grace_s, int spell);
  };
  struct Watches {
    int spell = -1;  // that they belong to
    Watch nearly;
    Watch truly;
    Watch clearly;
  };

  std::string_view name_;
  double margin_;
  PerSide<std::map<int, Watches>> watches_;  // by number
};

}  // namespace autoref::runner::ground_truth
