#include "runner/judge/judge_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "referee/machine/machine.hpp"
#include "runner/io/csv.hpp"
#include "runner/io/json.hpp"
#include "runner/judge/judge_measures.hpp"
#include "runner/results/scores.hpp"

namespace autoref::runner {
namespace {

using ground_truth::Outcome;

std::string fault_line(const JudgeGame& game, std::size_t number,
                       const ground_truth::Verdict& verdict) {
  const bool is_missed = verdict.outcome == Outcome::kMissed;
  return csv_line({game.rules, game.camera, game.id, std::to_string(game.configuration.seed),
                   std::string(name_of(game.configuration.match.a_plays)), verdict.name,
                   is_missed ? "missed" : "wrong", fmt::format("{:.3f}", verdict.time_s),
                   verdict.offender ? std::string(name_of(*verdict.offender)) : "",
                   verdict.is_borderline ? "yes" : "no",
                   fmt::format("{}{}{}", game.game_id, kFaultMark, number)}) +
         "\n";
}

// Adds a game's faults to the lists of calls to inspect.
void list_faults(const JudgeGame& game, const GameRow& row, JudgeReport& report) {
  const CallEvaluation& evaluation = row.evaluation;
  for (const ground_truth::Verdict& verdict : evaluation.verdicts) {
    if (verdict.is_second) {
      report.second_calls.push_back(
          fmt::format("{}: {} at {:.3f} s", game.id, verdict.name, verdict.time_s));
    }
  }
  const std::vector<const ground_truth::Verdict*> faults = faults_in(evaluation);
  for (std::size_t i = 0; i < faults.size(); ++i)
    report.faults_csv += fault_line(game, i + 1, *faults[i]);
  for (const std::string& call : evaluation.calls_in_stop) {
    report.calls_in_stop.push_back(fmt::format("{}: {}", game.id, call));
  }
  if (is_void(row.record)) {
    report.void_games.push_back(fmt::format("{}: {}", game.id, row.record.void_reason));
  }
}

CameraTally& tally_of(JudgeReport& report, const JudgeGame& game) {
  return *std::find_if(report.tallies.begin(), report.tallies.end(), [&](const auto& tally) {
    return tally.rules == game.rules && tally.camera == game.camera;
  });
}

std::vector<std::string> never_taken(const std::set<std::string, std::less<>>& taken) {
  std::vector<std::string> never;
  for (const std::string_view label : referee::all_labels()) {
    if (!taken.contains(label)) never.emplace_back(label);
  }
  return never;
}

std::vector<std::string> never_seen(const std::vector<CameraTally>& tallies) {
  std::vector<std::string> never;
  for (const std::string& name : call_names()) {
    const bool seen = std::any_of(tallies.begin(), tallies.end(), [&name](const auto& tally) {
      return tally.events.contains(name);
    });
    if (!seen) never.push_back(name);
  }
  return never;
}

Json json_of(const CameraTally& tally, const std::string& name, const EventTally& event) {
  Json object = {{"rules", tally.rules}, {"camera", tally.camera}, {"event", name}};
  for (const Measure& measure : measures()) {
    const std::optional<double> value = measure.value(event);
    object[measure.name] = value ? Json(rounded(*value, measure.decimals)) : Json();
  }
  return object;
}

Json last_touch_json(const CameraTally& tally, std::size_t team) {
  const LastTouchTally& touch = tally.last_touch[team];
  return {{"rules", tally.rules}, {"camera", tally.camera}, {"touched_by", team == 0 ? "a" : "b"},
          {"right", touch.right}, {"wrong", touch.wrong},   {"unknown", touch.unknown}};
}

}  // namespace

std::vector<const ground_truth::Verdict*> faults_in(const CallEvaluation& evaluation) {
  std::vector<const ground_truth::Verdict*> faults;
  for (const ground_truth::Verdict& verdict : evaluation.verdicts) {
    if (verdict.outcome == ground_truth::Outcome::kMissed ||
        verdict.outcome == ground_truth::Outcome::kWrong)
      faults.push_back(&verdict);
  }
  return faults;
}

JudgeReport report_of(const JudgeSchedule& schedule, const RowsById& rows) {
  JudgeReport report;
  report.faults_csv =
      "rules,camera,game,seed,a_plays,event,outcome,time_s,offender,borderline,id\n";
  for (const std::string& rules : schedule.rules) {
    for (const std::string& camera : schedule.cameras) {
      report.tallies.push_back({rules, camera, 0, 0, {}, {}});
    }
  }
  std::set<std::string, std::less<>> taken;
  for (const JudgeGame& game : games_of(schedule)) {
    const auto row = rows.find(game.game_id);
    if (row == rows.end()) continue;
    const GameRecord& record = row->second.record;
    tally_of(report, game).add(record, row->second.evaluation);
    list_faults(game, row->second, report);
    taken.insert(record.transitions.begin(), record.transitions.end());
  }
  report.transitions_never_used = never_taken(taken);
  report.rules_never_seen = never_seen(report.tallies);
  return report;
}

std::string csv_of(const JudgeReport& report) {
  std::vector<std::string> heads = {"rules", "camera", "event"};
  for (const Measure& measure : measures()) heads.emplace_back(measure.name);
  std::string text = csv_line(heads) + "\n";
  for (const CameraTally& tally : report.tallies) {
    for (const auto& [name, event] : tally.events) {
      std::vector<std::string> cells = {tally.rules, tally.camera, name};
      for (const Measure& measure : measures()) cells.push_back(text_of(measure, event));
      text += csv_line(cells) + "\n";
    }
  }
  return text;
}

std::string json_of(const JudgeReport& report) {
  Json events = Json::array();
  Json touches = Json::array();
  for (const CameraTally& tally : report.tallies) {
    for (const auto& [name, event] : tally.events) events.push_back(json_of(tally, name, event));
    for (const std::size_t team : {0U, 1U}) touches.push_back(last_touch_json(tally, team));
  }
  return json_text({{"events", std::move(events)},
                    {"last_touch", std::move(touches)},
                    {"second_calls", report.second_calls},
                    {"calls_in_stop", report.calls_in_stop},
                    {"void_games", report.void_games},
                    {"transitions_never_used", report.transitions_never_used},
                    {"events_never_seen", report.rules_never_seen}});
}

}  // namespace autoref::runner
