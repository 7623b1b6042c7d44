// A foul by the rules of 2026 that counts for a team, whichever of its robots commits it.
#pragma once

#include <optional>
#include <string_view>

#include "runner/judge/truth/scene.hpp"
#include "soccer/units.hpp"

namespace autoref::runner::ground_truth {

// Rules of 2026, "Offenses": a team's grace until the same foul is raised again.
inline constexpr double kTeamGrace_s = 2_s;

// To half a frame: times are whole frames apart.
bool has_passed(const Scene& scene, double since_s, double duration_s);

// The robot of a team that is farthest beyond a threshold, `excess` in the threshold's unit.
struct WorstRobot {
  std::optional<RobotId> robot;
  Vec2 position_m{0, 0};
  double excess = 0;

  void consider(RobotId id, const sim::RobotState& state, double its_excess);
};

// Several robots of a team within the grace commit one foul; after the grace the same foul is
// raised again, at once, if the team still or again commits it.
class TeamFoul {
 public:
  // `margin`: how near to the threshold a foul is open to reading, in the threshold's unit.
  TeamFoul(std::string_view name, double margin) : name_(name), margin_(margin) {}

  // To be called in every frame in which the rule holds. Whether the foul is raised in this one.
  bool watch(const Scene& scene, Side side, const WorstRobot& worst, TrueEvents& all);
  // As if the team's foul had been raised at that time.
  void begin_grace(Side side, double time_s) { raised_s_[side] = nearly_s_[side] = time_s; }

 private:
  std::string_view name_;
  double margin_;
  PerSide<double> raised_s_{{-1e9, -1e9}};
  PerSide<double> nearly_s_{{-1e9, -1e9}};  // the same of fouls and near misses
};

}  // namespace autoref::runner::ground_truth
