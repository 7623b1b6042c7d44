#include "experiments/kinds/all_kinds.hpp"

#include <algorithm>
#include <array>

#include "experiments/kinds/compare/comparison.hpp"
#include "experiments/kinds/gauntlet/gauntlet.hpp"
#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/kinds/knockout/knockout.hpp"
#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/kinds/rules/rules_experiment.hpp"
#include "experiments/kinds/situations/situations.hpp"
#include "experiments/kinds/sprt/sprt_match.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/kinds/swiss/swiss.hpp"
#include "experiments/kinds/tune/tuning.hpp"
#include "experiments/kinds/weakness/weakness.hpp"

namespace autoref::experiments {

std::span<const Kind* const> kinds_of_experiments() {
  static constexpr auto kAll = std::to_array<const Kind*>(
      {&Comparison::kKind, &Sweep::kKind, &RoundRobin::kKind, &Gauntlet::kKind, &SprtMatch::kKind,
       &Swiss::kKind, &Knockout::kKind, &Situations::kKind, &Weakness::kKind,
       &RulesExperiment::kKind, &Tuning::kKind, &JudgeSchedule::kKind});
  return kAll;
}

const Kind* find_kind(std::string_view name) {
  const auto all = kinds_of_experiments();
  const auto found =
      std::find_if(all.begin(), all.end(), [name](const Kind* kind) { return kind->name == name; });
  return found == all.end() ? nullptr : *found;
}

std::string kinds_played_by(std::string_view verb) {
  std::string text;
  std::string last;
  for (const Kind* kind : kinds_of_experiments()) {
    if (kind->verb != verb) continue;
    if (!last.empty()) text += (text.empty() ? "" : ", ") + last;
    last = kind->name;
  }
  return text.empty() ? last : text + " or " + last;
}

}  // namespace autoref::experiments
