#include "judge/judge_measures.hpp"

#include <fmt/format.h>

#include <optional>

namespace autoref::judge {
namespace {

using Tally = const EventTally&;
using Value = std::optional<double>;

Value delay_ms(Tally tally, double share) {
  const Value delay_s = quantile(tally.delays_s, share);
  return delay_s ? Value(1e3 * *delay_s) : std::nullopt;
}

Value position_error_mm(Tally tally) {
  const Value error_m = quantile(tally.errors_m, 0.5);
  return error_m ? Value(1e3 * *error_m) : std::nullopt;
}

}  // namespace

const std::vector<Measure>& measures() {
  static const std::vector<Measure> kMeasures = {
      {"happened", "happened", [](Tally t) -> Value { return t.happened(); }},
      {"calls", "calls", [](Tally t) -> Value { return t.calls(); }},
      {"right", "right", [](Tally t) -> Value { return t.right; }},
      {"precision", "precision", [](Tally t) -> Value { return t.precision(); }, 3,
       [](Tally t) { return t.precision_interval(); }},
      {"recall", "recall", [](Tally t) -> Value { return t.recall(); }, 3,
       [](Tally t) { return t.recall_interval(); }},
      {"F1", "f1", [](Tally t) -> Value { return t.f1(); }, 3,
       [](Tally t) { return t.f1_interval(); }},
      {"delay ms", "delay_median_ms", [](Tally t) { return delay_ms(t, 0.5); }},
      {"90 % ms", "delay_p90_ms", [](Tally t) { return delay_ms(t, 0.9); }},
      {"99 % ms", "delay_p99_ms", [](Tally t) { return delay_ms(t, 0.99); }},
      {"longest ms", "delay_max_ms", [](Tally t) { return delay_ms(t, 1.0); }},
      {"before event", "before_event", [](Tally t) -> Value { return t.before; }},
      {"position error mm", "position_error_median_mm", position_error_mm},
      {"early", "early", [](Tally t) -> Value { return t.early; }},
      {"near: missed", "borderline_missed", [](Tally t) -> Value { return t.borderline_missed; }},
      {"near: wrong", "borderline_wrong", [](Tally t) -> Value { return t.borderline_wrong; }},
      {"overtaken", "overtaken", [](Tally t) -> Value { return t.overtaken; }},
      {"in air", "in_air", [](Tally t) -> Value { return t.in_air; }},
      {"score", "score", [](Tally t) -> Value { return t.score(); }},
  };
  return kMeasures;
}

std::string text_of(const experiments::Interval& interval, int decimals) {
  return fmt::format("{:.{}f}, {:.{}f}", interval.low, decimals, interval.high, decimals);
}

std::string text_of(const Measure& measure, const EventTally& tally) {
  const Value value = measure.value(tally);
  if (!value) return "";
  std::string text = fmt::format("{:.{}f}", *value, measure.decimals);
  if (measure.interval == nullptr) return text;
  return fmt::format("{} [{}]", text, text_of(*measure.interval(tally), measure.decimals));
}

std::vector<MeasuredNumber> numbers_of(const EventTally& tally) {
  std::vector<MeasuredNumber> numbers;
  numbers.reserve(2 * measures().size());
  for (const Measure& measure : measures()) {
    const std::string name = measure.name;
    numbers.push_back({name, measure.value(tally), measure.decimals});
    if (measure.interval == nullptr) continue;
    const std::optional<experiments::Interval> interval = measure.interval(tally);
    const auto low = interval ? Value(interval->low) : std::nullopt;
    const auto high = interval ? Value(interval->high) : std::nullopt;
    numbers.push_back({name + "_low95", low, measure.decimals});
    numbers.push_back({name + "_high95", high, measure.decimals});
  }
  return numbers;
}

}  // namespace autoref::judge
