#include "runner/judge/judge_measures.hpp"

#include <fmt/format.h>

#include <optional>

namespace autoref::runner {
namespace {

// Share of right calls that come within the reported upper delay.
constexpr double kMostCalls = 0.95;

std::string count(int number) { return std::to_string(number); }

std::string ratio(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "";
}

std::string thousandths(const std::optional<double>& value) {
  return value ? fmt::format("{:.0f}", 1e3 * *value) : "";
}

}  // namespace

const std::vector<Measure>& measures() {
  using Tally = const EventTally&;
  static const std::vector<Measure> kMeasures = {
      {"happened", "happened", [](Tally t) { return count(t.happened()); }},
      {"calls", "calls", [](Tally t) { return count(t.calls()); }},
      {"right", "right", [](Tally t) { return count(t.right); }},
      {"precision", "precision", [](Tally t) { return ratio(t.precision()); }},
      {"recall", "recall", [](Tally t) { return ratio(t.recall()); }},
      {"F1", "f1", [](Tally t) { return ratio(t.f1()); }},
      {"delay ms", "delay_median_ms",
       [](Tally t) { return thousandths(quantile(t.delays_s, 0.5)); }},
      {"95 % ms", "delay_p95_ms",
       [](Tally t) { return thousandths(quantile(t.delays_s, kMostCalls)); }},
      {"position error mm", "position_error_median_mm",
       [](Tally t) { return thousandths(quantile(t.errors_m, 0.5)); }},
      {"early", "early", [](Tally t) { return count(t.early); }},
      {"near: missed", "borderline_missed", [](Tally t) { return count(t.borderline_missed); }},
      {"near: wrong", "borderline_wrong", [](Tally t) { return count(t.borderline_wrong); }},
      {"overtaken", "overtaken", [](Tally t) { return count(t.overtaken); }},
      {"in air", "in_air", [](Tally t) { return count(t.in_air); }},
      {"score", "score", [](Tally t) { return count(t.score()); }},
  };
  return kMeasures;
}

}  // namespace autoref::runner
