#include "judge/truth/team_foul.hpp"

namespace autoref::judge::ground_truth {

bool has_passed(const Scene& scene, double since_s, double duration_s) {
  return scene.time_s - since_s >= duration_s - scene.frame_s / 2;
}

void WorstRobot::consider(RobotId id, const sim::RobotState& state, double its_excess) {
  if (robot && its_excess <= excess) return;
  robot = id;
  position_m = state.position_m;
  excess = its_excess;
}

bool TeamFoul::watch(const Scene& scene, Side side, const WorstRobot& worst, TrueEvents& all) {
  const bool is_near = worst.robot && worst.excess > -margin_;
  if (!is_near || !has_passed(scene, raised_s_[side], kTeamGrace_s)) return false;
  const bool is_foul = worst.excess > 0;
  if (!is_foul && !has_passed(scene, nearly_s_[side], kTeamGrace_s)) return false;
  nearly_s_[side] = scene.time_s;
  if (is_foul) raised_s_[side] = scene.time_s;
  add_measured(all, {name_, scene.time_s, side, worst.robot, worst.position_m}, worst.excess,
               margin_);
  return is_foul;
}

}  // namespace autoref::judge::ground_truth
