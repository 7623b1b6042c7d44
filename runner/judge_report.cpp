#include "runner/judge_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "referee/machine.hpp"
#include "runner/csv.hpp"
#include "runner/json.hpp"

namespace autoref::runner {
namespace {

using truth::Outcome;
using truth::Verdict;

// Right calls of this part come no later.
constexpr double kMostCalls = 0.95;

// A figure of an event: how a table and how a program names it.
struct Figure {
  const char* head;  // of the table's column; nullptr: in CSV and JSON only
  const char* name;
  std::string (*text)(const EventTally& tally);
};

std::string count(int number) { return std::to_string(number); }

std::string ratio(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "";
}

std::string thousandths(const std::optional<double>& value) {
  return value ? fmt::format("{:.0f}", 1e3 * *value) : "";
}

const std::vector<Figure>& figures() {
  using Tally = const EventTally&;
  static const std::vector<Figure> kFigures = {
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
      {"place mm", "place_error_median_mm",
       [](Tally t) { return thousandths(quantile(t.errors_m, 0.5)); }},
      {"early", "early", [](Tally t) { return count(t.early); }},
      {"near: missed", "borderline_missed", [](Tally t) { return count(t.borderline_missed); }},
      {"near: wrong", "borderline_wrong", [](Tally t) { return count(t.borderline_wrong); }},
      {"overtaken", "overtaken", [](Tally t) { return count(t.overtaken); }},
      {"in air", "in_air", [](Tally t) { return count(t.in_air); }},
      {"score", "score", [](Tally t) { return count(t.score()); }},
  };
  return kFigures;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string markdown_head(const std::vector<std::string>& heads, std::size_t names) {
  std::vector<std::string> rule(heads.size(), "--:");
  std::fill_n(rule.begin(), names, "---");
  return markdown_row(heads) + fmt::format("|{}|\n", fmt::join(rule, "|"));
}

// The events of a book in the referee's order, each with its cameras below each other.
std::string events_table(const JudgeReport& report, const std::string& rules) {
  std::vector<std::string> heads = {"event", "camera"};
  for (const Figure& figure : figures()) heads.emplace_back(figure.head);
  std::string text = markdown_head(heads, 2);
  for (const std::string& name : call_names()) {
    for (const CameraTally& tally : report.tallies) {
      const auto found = tally.events.find(name);
      if (tally.rules != rules || found == tally.events.end()) continue;
      std::vector<std::string> cells = {needs_height(name) ? name + " (height)" : name,
                                        tally.camera};
      for (const Figure& figure : figures()) cells.push_back(figure.text(found->second));
      text += markdown_row(cells);
    }
  }
  return text;
}

std::string percent(int part, int whole) {
  return whole == 0 ? "" : fmt::format("{:.1f} %", 100.0 * part / whole);
}

std::string last_touch_table(const JudgeReport& report) {
  std::string text = markdown_head(
      {"last touch at exits", "camera", "touched by", "right", "wrong", "unknown", "of"}, 3);
  for (const CameraTally& tally : report.tallies) {
    for (std::size_t team = 0; team < tally.last_touch.size(); ++team) {
      const LastTouchTally& touch = tally.last_touch[team];
      const int all = touch.right + touch.wrong + touch.unknown;
      text +=
          markdown_row({tally.rules, tally.camera, team == 0 ? "a" : "b", percent(touch.right, all),
                        percent(touch.wrong, all), percent(touch.unknown, all), count(all)});
    }
  }
  return text;
}

std::string list(const std::string& what, const std::vector<std::string>& lines) {
  constexpr std::size_t kMost = 20;
  std::string text =
      fmt::format("{}: {}\n", what, lines.empty() ? "none" : count(int(lines.size())));
  for (std::size_t i = 0; i < std::min(kMost, lines.size()); ++i) text += "- " + lines[i] + "\n";
  if (lines.size() > kMost) text += fmt::format("- and {} more\n", lines.size() - kMost);
  return text;
}

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

std::string fault_line(const JudgeGame& game, const Verdict& verdict) {
  const bool is_missed = verdict.outcome == Outcome::kMissed;
  return csv_line({game.rules, game.camera, game.id, std::to_string(game.configuration.seed),
                   std::string(name_of(game.configuration.match.a_plays)), verdict.name,
                   is_missed ? "missed" : "wrong", fmt::format("{:.3f}", verdict.time_s),
                   verdict.offender ? std::string(name_of(*verdict.offender)) : "",
                   verdict.is_borderline ? "yes" : "no"}) +
         "\n";
}

// Adds one game to the lists of what is to be looked up.
void list_faults(const JudgeGame& game, const Judgement& judgement, JudgeReport& report) {
  for (const Verdict& verdict : judgement.verdicts) {
    if (verdict.is_second) {
      report.second_calls.push_back(
          fmt::format("{}: {} at {:.3f} s", game.id, verdict.name, verdict.time_s));
    }
    if (verdict.outcome == Outcome::kMissed || verdict.outcome == Outcome::kWrong) {
      report.faults_csv += fault_line(game, verdict);
    }
  }
  for (const std::string& call : judgement.calls_in_stop) {
    report.calls_in_stop.push_back(fmt::format("{}: {}", game.id, call));
  }
  if (!judgement.void_reason.empty()) {
    report.void_games.push_back(fmt::format("{}: {}", game.id, judgement.void_reason));
  }
}

CameraTally& tally_of(JudgeReport& report, const JudgeGame& game) {
  return *std::find_if(report.tallies.begin(), report.tallies.end(), [&](const auto& tally) {
    return tally.rules == game.rules && tally.camera == game.camera;
  });
}

std::vector<std::string> never_taken(const std::set<std::string, std::less<>>& taken) {
  std::vector<std::string> never;
  for (const auto& part : {referee::arrows_in_figure(), referee::arrows_outside_figure()}) {
    for (const referee::Arrow& arrow : part) {
      if (!taken.contains(arrow.label)) never.emplace_back(arrow.label);
    }
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
  for (const Figure& figure : figures()) {
    const std::string text = figure.text(event);
    object.add(figure.name, text.empty() ? "null" : text);
  }
  return object.text();
}

std::string last_touch_json(const CameraTally& tally, std::size_t team) {
  const LastTouchTally& touch = tally.last_touch[team];
  return JsonObject()
      .add("rules", json_text(tally.rules))
      .add("camera", json_text(tally.camera))
      .add("touched_by", json_text(team == 0 ? "a" : "b"))
      .add("right", count(touch.right))
      .add("wrong", count(touch.wrong))
      .add("unknown", count(touch.unknown))
      .text();
}

std::string texts_json(const std::vector<std::string>& lines) {
  std::vector<std::string> texts;
  for (const std::string& line : lines) texts.push_back(json_text(line));
  return json_list(texts);
}

}  // namespace

JudgeReport report_of(const JudgePlan& plan, const std::vector<Judgement>& judgements) {
  JudgeReport report;
  report.faults_csv = "rules,camera,game,seed,a_plays,event,outcome,time_s,offender,borderline\n";
  for (const std::string& rules : plan.rules) {
    for (const std::string& camera : plan.cameras) {
      report.tallies.push_back({rules, camera, 0, 0, {}, {}});
    }
  }
  std::set<std::string, std::less<>> taken;
  const std::vector<JudgeGame> games = games_of(plan);
  for (std::size_t i = 0; i < games.size(); ++i) {
    tally_of(report, games[i]).add(judgements[i]);
    list_faults(games[i], judgements[i], report);
    taken.insert(judgements[i].arrows.begin(), judgements[i].arrows.end());
  }
  report.arrows_never_taken = never_taken(taken);
  report.rules_never_seen = never_seen(report.tallies);
  return report;
}

std::string markdown_of(const JudgeReport& report) {
  std::string text;
  std::string rules;
  for (const CameraTally& tally : report.tallies) {
    if (tally.rules == rules) continue;
    rules = tally.rules;
    text += fmt::format("rules: {}, {} games under each camera\n\n{}\n", rules, tally.games,
                        events_table(report, rules));
  }
  text += last_touch_table(report) + "\n";
  text += list("events called twice", report.second_calls);
  text += list("calls that need play while there was none", report.calls_in_stop);
  text += list("void games", report.void_games);
  text += fmt::format("arrows never taken: {}\n", joined(report.arrows_never_taken));
  return text + fmt::format("events never seen: {}\n", joined(report.rules_never_seen));
}

std::string csv_of(const JudgeReport& report) {
  std::vector<std::string> heads = {"rules", "camera", "event"};
  for (const Figure& figure : figures()) heads.emplace_back(figure.name);
  std::string text = csv_line(heads) + "\n";
  for (const CameraTally& tally : report.tallies) {
    for (const auto& [name, event] : tally.events) {
      std::vector<std::string> cells = {tally.rules, tally.camera, name};
      for (const Figure& figure : figures()) cells.push_back(figure.text(event));
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
      .add("arrows_never_taken", texts_json(report.arrows_never_taken))
      .add("events_never_seen", texts_json(report.rules_never_seen))
      .text();
}

}  // namespace autoref::runner
