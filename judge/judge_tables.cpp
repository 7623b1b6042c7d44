#include "judge/judge_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "experiments/statistics/interval.hpp"
#include "io/csv.hpp"
#include "judge/judge_measures.hpp"

namespace autoref::judge {
namespace {

using Tallies = std::vector<CameraTally>;

// The distinct values of a name, in order.
std::vector<std::string> names_in(const Tallies& tallies, std::string CameraTally::*name) {
  std::vector<std::string> names;
  for (const CameraTally& tally : tallies) {
    if (std::find(names.begin(), names.end(), tally.*name) == names.end()) {
      names.push_back(tally.*name);
    }
  }
  return names;
}

bool has_named_seeds(const JudgeReport& report) {
  return !report.tallies.empty() && !report.tallies.front().seeds.empty();
}

// Adds the name of the master seed if the seeds have names.
io::Cells with_seeds(const JudgeReport& report, io::Cells cells, const std::string& seeds) {
  if (has_named_seeds(report)) cells.push_back(seeds);
  return cells;
}

JudgeTable table_of(const JudgeReport& report, const io::Cells& names, const io::Cells& numbers) {
  JudgeTable table{{with_seeds(report, names, "seeds")}, 0};
  table.names = table.rows.front().size();
  table.rows.front().insert(table.rows.front().end(), numbers.begin(), numbers.end());
  return table;
}

std::string shown_name(const std::string& event) {
  return needs_height(event) ? event + " (height)" : event;
}

std::string rarity(const EventTally& tally) { return tally.is_rare() ? " rare" : ""; }

std::string score_cell(const EventTally& tally, ScoreCells cells) {
  const std::optional<double> f1 = tally.f1();
  if (!f1) return "";
  const bool is_short = cells == ScoreCells::kShort;
  return fmt::format("{:.3f}{} of {}{}", *f1,
                     is_short ? "" : fmt::format(" [{}]", text_of(*tally.f1_interval(), 3)),
                     tally.happened(), rarity(tally));
}

// One cell for each tally with the same seeds and rule book as `of`, that is, for each camera.
template <typename CellOf>
io::Cells by_camera(const Tallies& tallies, const CameraTally& of, const CellOf& cell_of) {
  io::Cells cells;
  for (const CameraTally& tally : tallies) {
    if (tally.seeds == of.seeds && tally.rules == of.rules) cells.push_back(cell_of(tally));
  }
  return cells;
}

// F1 of one event with one rule book and one seed, by camera; nullopt if it was never seen.
std::optional<io::Cells> score_cells(const Tallies& tallies, const CameraTally& of,
                                     const std::string& event, ScoreCells style) {
  io::Cells cells = by_camera(tallies, of, [&](const CameraTally& tally) {
    const auto found = tally.events.find(event);
    return found == tally.events.end() ? "" : score_cell(found->second, style);
  });
  const bool is_known =
      std::any_of(cells.begin(), cells.end(), [](const auto& cell) { return !cell.empty(); });
  return is_known ? std::optional(std::move(cells)) : std::nullopt;
}

// Adds the rows of an event, one for each rule book and seed among the tallies.
void add_scores(const JudgeReport& report, const Tallies& tallies, const std::string& event,
                ScoreCells style, TableRows& rows) {
  const std::vector<std::string> cameras = names_in(tallies, &CameraTally::camera);
  for (const CameraTally& tally : tallies) {
    if (tally.camera != cameras.front()) continue;
    const auto scores = score_cells(tallies, tally, event, style);
    if (!scores) continue;
    rows.push_back(with_seeds(report, {shown_name(event), tally.rules}, tally.seeds));
    rows.back().insert(rows.back().end(), scores->begin(), scores->end());
  }
}

// "98.1 % [97.0, 98.8]".
std::string percent(int part, int whole) {
  if (whole == 0) return "";
  const experiments::Interval interval = *experiments::wilson_interval(part, whole);
  return fmt::format("{:.1f} % [{}]", 100.0 * part / whole,
                     text_of({100 * interval.low, 100 * interval.high}, 1));
}

// "98.1 % [97.0, 98.8] of 3029".
std::string touch_cell(const std::array<experiments::LastTouchTally, 2>& by_team) {
  const EventTally touch = touch_tally(by_team);
  if (touch.happened() == 0) return "";
  return fmt::format("{} of {}{}", percent(touch.right, touch.happened()), touch.happened(),
                     rarity(touch));
}

io::Cells touch_cells(const std::array<experiments::LastTouchTally, 2>& by_team) {
  const EventTally touch = touch_tally(by_team);
  const int all = touch.happened();
  return {percent(touch.right, all), percent(touch.wrong, all),
          percent(touch.missed - touch.wrong, all), std::to_string(all)};
}

void add_touches(const JudgeReport& report, const Tallies& tallies, TableRows& rows) {
  for (const CameraTally& tally : tallies) {
    rows.push_back(with_seeds(report, {tally.rules, tally.camera}, tally.seeds));
    for (const auto* touches : {&tally.last_touch, &tally.contested_touch}) {
      const io::Cells cells = touch_cells(*touches);
      rows.back().insert(rows.back().end(), cells.begin(), cells.end());
    }
  }
}

const Tallies& tallies_with(const JudgeReport& report, const std::string& rules) {
  return rules == kAllRules ? report.pooled : report.tallies;
}

void add_reliability(const JudgeReport& report, const std::string& seeds, TableRows& rows) {
  Reliability all;
  for (const CameraTally& tally : report.tallies) {
    if (tally.seeds == seeds) all.add(tally.reliability);
  }
  for (std::size_t i = 0; i < Reliability::kFrom.size(); ++i) {
    const ReliabilityBand& band = all.band(i);
    if (band.calls == 0) continue;
    const bool is_last = i + 1 == Reliability::kFrom.size();
    const double to = is_last ? 1 : Reliability::kFrom[i + 1];
    rows.push_back(
        with_seeds(report, {fmt::format("{:.2f} to {:.2f}", Reliability::kFrom[i], to)}, seeds));
    const io::Cells cells = {std::to_string(band.calls),
                             fmt::format("{:.1f} %", 100 * band.confidence_sum / band.calls),
                             percent(band.right, band.calls)};
    rows.back().insert(rows.back().end(), cells.begin(), cells.end());
  }
}

// Delays by camera are pooled over rule books: those of a single book are in its own table.
const Tallies& widest_tallies(const JudgeReport& report) {
  return report.pooled.empty() ? report.tallies : report.pooled;
}

void add_summary(const io::Cells& name, const io::Cells& cells, TableRows& rows) {
  rows.push_back(name);
  rows.back().insert(rows.back().end(), cells.begin(), cells.end());
}

}  // namespace

const char* const kSummaryCaption =
    "How often the last touch was right when the ball left the field, and F1 of each event, in the "
    "games of all rule books. In brackets: 95 % confidence intervals. `rare`: it happened fewer "
    "than 100 times.";
const char* const kIntervalsCaption =
    "In brackets: 95 % confidence intervals, Wilson's for proportions; F1 is treated as the "
    "proportion of right calls in the mean of the numbers of calls and of events. `rare`: the "
    "event happened fewer than 100 times.";
const char* const kLastTouchCaption =
    "Contested: robots of both teams touched the ball within the last 0.1 s before it left the "
    "field.";
const char* const kDelaysCaption =
    "From the event to the right call. Before event: calls that came before an event that did "
    "happen; their delays are negative. Early: calls of events that could no longer happen, since "
    "play was stopped.";
const char* const kReliabilityCaption =
    "Calls by the referee's confidence (`confidence` in event logs). If it is well calibrated, the "
    "proportion of right calls is the mean confidence.";

std::vector<std::string> books_in(const JudgeReport& report) {
  std::vector<std::string> books = names_in(report.tallies, &CameraTally::rules);
  if (!report.pooled.empty()) books.emplace_back(kAllRules);
  return books;
}

JudgeTable reliability_table(const JudgeReport& report) {
  JudgeTable table = table_of(report, {"confidence"}, {"calls", "mean confidence", "right"});
  for (const std::string& seeds : names_in(report.tallies, &CameraTally::seeds))
    add_reliability(report, seeds, table.rows);
  return table;
}

// The events of a rule book in the referee's order, with one row per camera and seed.
JudgeTable events_table(const JudgeReport& report, const std::string& rules) {
  io::Cells heads;
  for (const Measure& measure : measures()) heads.emplace_back(measure.head);
  JudgeTable table = table_of(report, {"event", "camera"}, heads);
  for (const std::string& name : judged_names()) {
    if (rules == kAllRules && !report.rare_events.contains(name)) continue;
    for (const CameraTally& tally : tallies_with(report, rules)) {
      const auto found = tally.events.find(name);
      if (tally.rules != rules || found == tally.events.end()) continue;
      const std::string shown = shown_name(name) + rarity(found->second);
      table.rows.push_back(with_seeds(report, {shown, tally.camera}, tally.seeds));
      for (const Measure& measure : measures()) {
        table.rows.back().push_back(text_of(measure, found->second));
      }
    }
  }
  return table;
}

JudgeTable summary_table(const JudgeReport& report) {
  const Tallies& tallies = widest_tallies(report);
  JudgeTable table{{{"summary"}}, 1};
  TableRows& rows = table.rows;
  if (tallies.empty()) return table;
  const CameraTally& of = tallies.back();
  if (!of.seeds.empty()) rows[0][0] += " of " + of.seeds;
  const io::Cells cameras = by_camera(tallies, of, [](const auto& tally) { return tally.camera; });
  rows[0].insert(rows[0].end(), cameras.begin(), cameras.end());
  add_summary({"last touch at exits"},
              by_camera(tallies, of, [](const auto& t) { return touch_cell(t.last_touch); }), rows);
  add_summary({"contested last touch"},
              by_camera(tallies, of, [](const auto& t) { return touch_cell(t.contested_touch); }),
              rows);
  for (const std::string& event : judged_names()) {
    const auto scores = score_cells(tallies, of, event, ScoreCells::kWithIntervals);
    if (scores) add_summary({shown_name(event)}, *scores, rows);
  }
  return table;
}

JudgeTable scores_table(const JudgeReport& report, ScoreCells cells) {
  JudgeTable table =
      table_of(report, {"F1 of", "rules"}, names_in(report.tallies, &CameraTally::camera));
  for (const std::string& event : judged_names()) {
    add_scores(report, report.tallies, event, cells, table.rows);
  }
  return table;
}

JudgeTable last_touch_table(const JudgeReport& report) {
  JudgeTable table = table_of(report, {"last touch at exits", "camera"},
                              {"right", "wrong", "unknown", "of", "contested: right",
                               "contested: wrong", "contested: unknown", "contested: of"});
  add_touches(report, report.tallies, table.rows);
  add_touches(report, report.pooled, table.rows);
  return table;
}

JudgeTable delays_table(const JudgeReport& report) {
  static const std::vector<std::string> kNames = {"right",        "delay_median_ms", "delay_p90_ms",
                                                  "delay_p99_ms", "delay_max_ms",    "before_event",
                                                  "early"};
  std::vector<Measure> shown;
  io::Cells heads;
  for (const Measure& measure : measures()) {
    if (std::find(kNames.begin(), kNames.end(), measure.name) == kNames.end()) continue;
    shown.push_back(measure);
    heads.emplace_back(measure.head);
  }
  JudgeTable table = table_of(report, {"delays with rules", "camera"}, heads);
  for (const CameraTally& tally : widest_tallies(report)) {
    EventTally all;
    for (const auto& [name, event] : tally.events) all.add(event);
    table.rows.push_back(with_seeds(report, {tally.rules, tally.camera}, tally.seeds));
    for (const Measure& measure : shown) table.rows.back().push_back(text_of(measure, all));
  }
  return table;
}

}  // namespace autoref::judge
