// A staged world with scripted referee commands, and the ground-truth observer that watches both.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "judge/truth/ground_truth_observer.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::judge::ground_truth {

inline constexpr RobotId kWest0{Side::kWest, 0};
inline constexpr RobotId kWest1{Side::kWest, 1};
inline constexpr RobotId kEast0{Side::kEast, 0};
inline constexpr RobotId kEast1{Side::kEast, 1};

inline RuleBook book(const char* name) { return *find_rule_book(name); }

// Two robots per side on the paper's field. Number 0 is the keeper.
struct StagedGame {
  explicit StagedGame(const RuleBook& rules = book("2014"))
      : world(sim::quiet(), sim::specs(2, 2)), observer(world.field, rules, 60.0) {
    // These robots are out of the way.
    world.put_robot(kWest0, {-2.9, -0.5});
    world.put_robot(kWest1, {-1.0, -1.9});
    world.put_robot(kEast0, {2.9, -0.5}, {-1, 0});
    world.put_robot(kEast1, {1.0, -1.9}, {-1, 0});
    command(CommandKind::kStop);
  }

  // Sends a referee command immediately.
  void command(CommandKind kind, Side side = Side::kWest) {
    signal.command = {kind, side};
    ++signal.command_counter;
    observer.see(world.world, signal);
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      world.frame();
      observer.see(world.world, signal);
    }
  }
  void seconds(double s) { frames(static_cast<int>(s * 60 + 0.5)); }

  // Names of the true events.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const TrueEvent& event : observer.true_events()) {
      if (event.standing == Standing::kTrue) names.emplace_back(event.name);
    }
    return names;
  }
  bool has(const std::string& name) const {
    const std::vector<std::string> all = names();
    return std::find(all.begin(), all.end(), name) != all.end();
  }
  // Times of the true events with this name.
  std::vector<double> times_s(std::string_view name) const {
    std::vector<double> times_s;
    for (const TrueEvent& event : observer.true_events()) {
      if (event.standing == Standing::kTrue && event.name == name) times_s.push_back(event.time_s);
    }
    return times_s;
  }
  // The first event with this name, which must exist.
  const TrueEvent& first(std::string_view name) const {
    return *std::find_if(
        observer.true_events().begin(), observer.true_events().end(),
        [&name](const TrueEvent& h) { return h.name == name && h.standing == Standing::kTrue; });
  }

  sim::Scene world;
  GroundTruthObserver observer;
  RefereeSignal signal;
};

}  // namespace autoref::judge::ground_truth
