// Factories of the ground-truth rules (ground_truth_rules.def), and the code for fouls that are
// counted per team, which several files share.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "judge/truth/true_frame.hpp"

namespace autoref::judge::ground_truth {

#define AUTOREF_GROUND_TRUTH(factory, ...) std::unique_ptr<GroundTruthRule> factory();
#include "judge/truth/ground_truth_rules.def"
#undef AUTOREF_GROUND_TRUTH

// The ground-truth rules for this rule book.
std::vector<std::unique_ptr<GroundTruthRule>> ground_truth_rules_of(const RuleBook& rules);

// Whether `duration_s` has passed since `since_s`, with a tolerance of half a frame because time is
// quantised to frames.
bool has_passed(const TrueFrame& frame, double since_s, double duration_s);

// The robot of a team farthest beyond a threshold; `excess` is in the threshold's unit.
struct WorstRobot {
  std::optional<RobotId> robot;
  Vec2 position_m{0, 0};
  double excess = 0;

  void consider(RobotId id, const sim::RobotState& state, double its_excess);
};

// A foul of the 2026 rules that is counted per team, whichever of its robots commits it. Several
// offending robots of a team within the grace period (2026 rules, "Offenses") count as a single
// foul. After the grace period, the foul is raised again as soon as the team commits it again, or
// immediately if the team still commits it.
class TeamFoul {
 public:
  // `margin`: distance to the threshold within which the rules leave a foul open to interpretation,
  // in the threshold's unit. `grace_s` is the rule book's grace period.
  TeamFoul(std::string_view name, double margin,
           double RuleBook::*grace_s = &RuleBook::foul_repeat_s)
      : name_(name), margin_(margin), grace_s_(grace_s) {}

  // Call in every frame in which the rule applies. Returns whether the foul is raised in this
  // frame.
  bool watch(const TrueFrame& frame, Side side, const WorstRobot& worst, TrueEvents& all);
  // Starts the grace period as if the team's foul had been raised at that time.
  void begin_grace(Side side, double time_s) { raised_s_[side] = nearly_s_[side] = time_s; }

 private:
  std::string_view name_;
  double margin_;
  double RuleBook::*grace_s_;
  PerSide<double> raised_s_{{-1e9, -1e9}};
  PerSide<double> nearly_s_{{-1e9, -1e9}};  // time of the latest foul or near miss
};

}  // namespace autoref::judge::ground_truth
