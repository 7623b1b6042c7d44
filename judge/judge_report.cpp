#include "judge/judge_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/results/game_row.hpp"
#include "io/csv.hpp"
#include "referee/machine/machine.hpp"

namespace autoref::judge {
namespace {

std::string fault_line(const experiments::ScheduledJudgeGame& game, std::size_t number,
                       const experiments::CallVerdict& verdict) {
  const bool is_missed = verdict.outcome == experiments::CallOutcome::kMissed;
  return io::csv_line({game.seeds, game.rules, game.camera, game.id,
                       std::to_string(game.settings.leg().seed),
                       std::string(name_of(game.settings.leg().a_plays)), verdict.name,
                       is_missed ? "missed" : "wrong", fmt::format("{:.3f}", verdict.time_s),
                       verdict.offender ? std::string(name_of(*verdict.offender)) : "",
                       verdict.is_borderline ? "yes" : "no",
                       fmt::format("{}{}{}", game.game_id, kFaultMark, number)}) +
         "\n";
}

// Adds a game's faults to the lists of calls to inspect.
void list_faults(const experiments::ScheduledJudgeGame& game, const experiments::GameRow& row,
                 JudgeReport& report) {
  const experiments::CallEvaluation& evaluation = row.evaluation;
  for (const experiments::CallVerdict& verdict : evaluation.verdicts) {
    if (verdict.is_second) {
      report.second_calls.push_back(
          fmt::format("{}: {} at {:.3f} s", game.id, verdict.name, verdict.time_s));
    }
    if (is_before_event(verdict)) {
      report.calls_before_events.push_back(
          fmt::format("{}: {} at {:.3f} s, {:.0f} ms before the event", game.id, verdict.name,
                      verdict.time_s + verdict.delay_s, -1e3 * verdict.delay_s));
    }
  }
  const std::vector<const experiments::CallVerdict*> faults = faults_in(evaluation);
  for (std::size_t i = 0; i < faults.size(); ++i)
    report.faults_csv += fault_line(game, i + 1, *faults[i]);
  for (const std::string& call : evaluation.calls_in_stop) {
    report.calls_in_stop.push_back(fmt::format("{}: {}", game.id, call));
  }
  if (experiments::is_void(row.record)) {
    report.void_games.push_back(fmt::format("{}: {}", game.id, row.record.void_reason));
  }
}

CameraTally& tally_of(JudgeReport& report, const experiments::ScheduledJudgeGame& game) {
  return *std::find_if(report.tallies.begin(), report.tallies.end(), [&](const auto& tally) {
    return tally.seeds == game.seeds && tally.rules == game.rules && tally.camera == game.camera;
  });
}

void add_empty_tallies(const experiments::JudgeSchedule& schedule, const std::string& rules,
                       std::vector<CameraTally>& tallies) {
  for (const std::string& camera : schedule.cameras) {
    for (const experiments::NamedSeed& seed : schedule.seeds) {
      tallies.push_back({seed.name, rules, camera, 0, 0, {}, {}, {}, {}});
    }
  }
}

// Fills `pooled` and `rare_events`, given the tallies.
void pool(const experiments::JudgeSchedule& schedule, JudgeReport& report) {
  if (schedule.rules.size() < 2) return;
  add_empty_tallies(schedule, kAllRules, report.pooled);
  std::map<std::string, std::set<std::string>> books;  // rule books by event
  for (std::size_t i = 0; i < report.tallies.size(); ++i) {
    const CameraTally& tally = report.tallies[i];
    report.pooled[i % report.pooled.size()].add(tally);
    for (const auto& [name, event] : tally.events) books[name].insert(tally.rules);
  }
  for (const CameraTally& tally : report.tallies) {
    for (const auto& [name, event] : tally.events) {
      if (event.is_rare() && books[name].size() > 1) report.rare_events.insert(name);
    }
  }
}

std::vector<std::string> never_taken(const std::set<std::string_view>& taken) {
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

}  // namespace

std::vector<const experiments::CallVerdict*> faults_in(
    const experiments::CallEvaluation& evaluation) {
  std::vector<const experiments::CallVerdict*> faults;
  for (const experiments::CallVerdict& verdict : evaluation.verdicts) {
    if (verdict.outcome == experiments::CallOutcome::kMissed ||
        verdict.outcome == experiments::CallOutcome::kWrong)
      faults.push_back(&verdict);
  }
  return faults;
}

JudgeReport report_of(const experiments::JudgeSchedule& schedule,
                      const experiments::RowsById& rows) {
  JudgeReport report;
  report.faults_csv =
      "seeds,rules,camera,game,seed,a_plays,event,outcome,time_s,offender,borderline,id\n";
  report.seeds = schedule.seeds;
  for (const std::string& rules : schedule.rules) {
    add_empty_tallies(schedule, rules, report.tallies);
  }
  std::set<std::string_view> taken;
  for (const experiments::ScheduledJudgeGame& game : experiments::games_of(schedule)) {
    const auto row = rows.find(game.game_id);
    if (row == rows.end()) continue;
    const game::GameRecord& record = row->second.record;
    tally_of(report, game).add(record, row->second.evaluation);
    list_faults(game, row->second, report);
    taken.insert(record.transitions.begin(), record.transitions.end());
  }
  pool(schedule, report);
  report.transitions_never_used = never_taken(taken);
  report.rules_never_seen = never_seen(report.tallies);
  return report;
}

}  // namespace autoref::judge
