#include "runner/judge/judge_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

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

std::string json_of(const CameraTally& tally, const std::string& name, const EventTally& event) {
  JsonObject object;
  object.add("rules", json_text(tally.rules))
      .add("camera", json_text(tally.camera))
      .add("event", json_text(name));
  for (const Measure& measure : measures()) {
    const std::string text = text_of(measure, event);
    object.add(measure.name, text.empty() ? "null" : text);
  }
  return object.text();
}

std::string last_touch_json(const CameraTally& tally, std::size_t team) {
  const LastTouchTally& touch = tally.last_touch[team];
  return JsonObject()
      .add("rules", json_text(tally.rules))
      .add("camera", json_text(tally.camera))
      .add("touched_by", json_text(team == 0 ? "a" : "b"))
      .add("right", std::to_string(touch.right))
      .add("wrong", std::to_string(touch.wrong))
      .add("unknown", std::to_string(touch.unknown))
      .text();
}

std::string texts_json(const std::vector<std::string>& lines) {
  std::vector<std::string> texts;
  texts.reserve(lines.size());
  for (const std::string& line : lines) texts.push_back(json_text(line));
  return json_list(texts);
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
  std::vector<std::string> events;
  std::vector<std::string> touches;
  for (const CameraTally& tally : report.tallies) {
    for (const auto& [name, event] : tally.events) events.push_back(json_of(tally, name, event));
    for (const std::size_t team : {0U, 1U}) touches.push_back(last_touch_json(tally, team));
  }
  return JsonObject()
      .add("events", json_list(events))
      .add("last_touch", json_list(touches))
      .add("second_calls", texts_json(report.second_calls))
      .add("calls_in_stop", texts_json(report.calls_in_stop))
      .add("void_games", texts_json(report.void_games))
      .add("transitions_never_used", texts_json(report.transitions_never_used))
      .add("events_never_seen", texts_json(report.rules_never_seen))
      .text();
}

}  // namespace autoref::runner
