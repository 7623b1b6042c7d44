// Measures of events, and the judge's report as CSV and JSON, declared in judge_report.hpp.
#include "judge/judge_measures.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/csv.hpp"
#include "io/json.hpp"
#include "judge/judge_report.hpp"

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

// The events of judge.csv that stand for last touches.
constexpr const char* kLastTouchEvent = "last_touch";
constexpr const char* kContestedTouchEvent = "contested_touch";

io::Json json_of(const CameraTally& tally, const std::string& name, const EventTally& event) {
  io::Json object = {{"seeds", tally.seeds},
                     {"rules", tally.rules},
                     {"camera", tally.camera},
                     {"event", name},
                     {"rare", event.is_rare()}};
  for (const MeasuredNumber& number : numbers_of(event)) {
    object[number.name] =
        number.value ? io::Json(io::rounded(*number.value, number.decimals)) : io::Json();
  }
  return object;
}

io::Json last_touch_json(const CameraTally& tally, std::size_t team, bool is_contested) {
  const experiments::LastTouchTally& touch =
      (is_contested ? tally.contested_touch : tally.last_touch)[team];
  return {{"seeds", tally.seeds},      {"rules", tally.rules},
          {"camera", tally.camera},    {"touched_by", team == 0 ? "a" : "b"},
          {"contested", is_contested}, {"right", touch.right},
          {"wrong", touch.wrong},      {"unknown", touch.unknown}};
}

io::Json seeds_json(const std::vector<experiments::NamedSeed>& seeds) {
  io::Json list = io::Json::array();
  for (const experiments::NamedSeed& seed : seeds) {
    list.push_back({{"name", seed.name}, {"text", seed.text}, {"value", seed.value}});
  }
  return list;
}

// The events in a tally's rows of judge.csv, by name.
std::vector<std::pair<std::string, EventTally>> csv_events(const JudgeReport& report,
                                                           const CameraTally& tally) {
  std::vector<std::pair<std::string, EventTally>> events;
  for (const auto& [name, event] : tally.events) {
    if (tally.rules == kAllRules && !report.rare_events.contains(name)) continue;
    events.emplace_back(name, event);
  }
  events.emplace_back(kLastTouchEvent, touch_tally(tally.last_touch));
  events.emplace_back(kContestedTouchEvent, touch_tally(tally.contested_touch));
  return events;
}

// All tallies, those of single rule books first.
std::vector<const CameraTally*> all_tallies(const JudgeReport& report) {
  std::vector<const CameraTally*> all;
  for (const auto* tallies : {&report.tallies, &report.pooled}) {
    for (const CameraTally& tally : *tallies) all.push_back(&tally);
  }
  return all;
}

std::string csv_row(const CameraTally& tally, const std::string& name, const EventTally& event) {
  io::Cells cells = {tally.seeds, tally.rules, tally.camera, name, event.is_rare() ? "yes" : "no"};
  for (const MeasuredNumber& number : numbers_of(event)) {
    cells.push_back(number.value ? fmt::format("{:.{}f}", *number.value, number.decimals) : "");
  }
  return io::csv_line(cells) + "\n";
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

std::string csv_of(const JudgeReport& report) {
  io::Cells heads = {"seeds", "rules", "camera", "event", "rare"};
  for (const MeasuredNumber& number : numbers_of(EventTally{})) heads.push_back(number.name);
  std::string text = io::csv_line(heads) + "\n";
  for (const CameraTally* tally : all_tallies(report)) {
    for (const auto& [name, event] : csv_events(report, *tally)) {
      text += csv_row(*tally, name, event);
    }
  }
  return text;
}

std::string json_of(const JudgeReport& report) {
  io::Json events = io::Json::array();
  io::Json touches = io::Json::array();
  for (const CameraTally* tally : all_tallies(report)) {
    for (const auto& [name, event] : csv_events(report, *tally)) {
      events.push_back(json_of(*tally, name, event));
    }
    for (const std::size_t team : {0U, 1U}) {
      for (const bool is_contested : {false, true}) {
        touches.push_back(last_touch_json(*tally, team, is_contested));
      }
    }
  }
  return io::json_text({{"seeds", seeds_json(report.seeds)},
                        {"events", std::move(events)},
                        {"last_touch", std::move(touches)},
                        {"second_calls", report.second_calls},
                        {"calls_in_stop", report.calls_in_stop},
                        {"calls_before_events", report.calls_before_events},
                        {"void_games", report.void_games},
                        {"transitions_never_used", report.transitions_never_used},
                        {"events_never_seen", report.rules_never_seen}});
}

}  // namespace autoref::judge
