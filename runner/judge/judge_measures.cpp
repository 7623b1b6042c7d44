#include "runner/judge/judge_measures.hpp"

#include <fmt/format.h>

#include <optional>

namespace autoref::runner {
namespace {

// Proportion of right calls that come within the reported upper delay.
constexpr double kMostCalls = 0.95;

std::optional<double> in_thousandths(const std::optional<double>& value) {
  return value ? std::optional(1e3 * *value) : std::nullopt;
}

}  // namespace

const std::vector<Measure>& measures() {
  using Tally = const EventTally&;
  using Value = std::optional<double>;
  static const std::vector<Measure> kMeasures = {
      {"happened", "happened", [](Tally t) -> Value { return t.happened(); }},
      {"calls", "calls", [](Tally t) -> Value { return t.calls(); }},
      {"right", "right", [](Tally t) -> Value { return t.right; }},
      {"precision", "precision", [](Tally t) -> Value { return t.precision(); }, 3},
      {"recall", "recall", [](Tally t) -> Value { return t.recall(); }, 3},
      {"F1", "f1", [](Tally t) -> Value { return t.f1(); }, 3},
      {"delay ms", "delay_median_ms",
       [](Tally t) { return in_thousandths(quantile(t.delays_s, 0.5)); }},
      {"95 % ms", "delay_p95_ms",
       [](Tally t) { return in_thousandths(quantile(t.delays_s, kMostCalls)); }},
      {"position error mm", "position_error_median_mm",
       [](Tally t) { return in_thousandths(quantile(t.errors_m, 0.5)); }},
      {"early", "early", [](Tally t) -> Value { return t.early; }},
      {"near: missed", "borderline_missed", [](Tally t) -> Value { return t.borderline_missed; }},
      {"near: wrong", "borderline_wrong", [](Tally t) -> Value { return t.borderline_wrong; }},
      {"overtaken", "overtaken", [](Tally t) -> Value { return t.overtaken; }},
      {"in air", "in_air", [](Tally t) -> Value { return t.in_air; }},
      {"score", "score", [](Tally t) -> Value { return t.score(); }},
  };
  return kMeasures;
}

std::string text_of(const Measure& measure, const EventTally& tally) {
  const std::optional<double> value = measure.value(tally);
  return value ? fmt::format("{:.{}f}", *value, measure.decimals) : "";
}

}  // namespace autoref::runner
