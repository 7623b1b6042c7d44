#include "judge/truth/ground_truth_rules.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace autoref::judge::ground_truth {
namespace {

enum Editions : std::uint8_t { kAnyEdition, kBefore2026, kOnly2026 };

struct GroundTruthEntry {
  std::unique_ptr<GroundTruthRule> (*make)();
  Editions editions;
  std::array<std::optional<RuleId>, 2> rules{};
};

constexpr GroundTruthEntry kGroundTruth[] = {
#define AUTOREF_GROUND_TRUTH(factory, editions, ...) {factory, editions, {__VA_ARGS__}},
#include "judge/truth/ground_truth_rules.def"
#undef AUTOREF_GROUND_TRUTH
};

bool applies(const GroundTruthEntry& entry, const RuleBook& book) {
  const bool is_2026 = book.edition == Edition::kRules2026;
  if (entry.editions == (is_2026 ? kBefore2026 : kOnly2026)) return false;
  const auto& rules = entry.rules;
  return !rules.front() || std::any_of(rules.begin(), rules.end(),
                                       [&](const auto& rule) { return rule && book.has(*rule); });
}

}  // namespace

std::vector<std::unique_ptr<GroundTruthRule>> ground_truth_rules_of(const RuleBook& rules) {
  std::vector<std::unique_ptr<GroundTruthRule>> all;
  for (const GroundTruthEntry& entry : kGroundTruth) {
    if (applies(entry, rules)) all.push_back(entry.make());
  }
  return all;
}

bool has_passed(const TrueFrame& frame, double since_s, double duration_s) {
  return frame.time_s - since_s >= duration_s - frame.frame_s / 2;
}

void WorstRobot::consider(RobotId id, const sim::RobotState& state, double its_excess) {
  if (robot && its_excess <= excess) return;
  robot = id;
  position_m = state.position_m;
  excess = its_excess;
}

bool TeamFoul::watch(const TrueFrame& frame, Side side, const WorstRobot& worst, TrueEvents& all) {
  const bool is_near = worst.robot && worst.excess > -margin_;
  const double grace_s = frame.rules.*grace_s_;
  if (!is_near || !has_passed(frame, raised_s_[side], grace_s)) return false;
  const bool is_foul = worst.excess > 0;
  if (!is_foul && !has_passed(frame, nearly_s_[side], grace_s)) return false;
  nearly_s_[side] = frame.time_s;
  if (is_foul) raised_s_[side] = frame.time_s;
  add_measured(all, {name_, frame.time_s, side, worst.robot, worst.position_m}, worst.excess,
               margin_);
  return is_foul;
}

}  // namespace autoref::judge::ground_truth
