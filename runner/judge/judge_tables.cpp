#include "runner/judge/judge_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "runner/judge/judge_measures.hpp"

namespace autoref::runner {
namespace {

std::vector<std::string> cameras_in(const JudgeReport& report) {
  std::vector<std::string> cameras;
  for (const CameraTally& tally : report.tallies) {
    if (std::find(cameras.begin(), cameras.end(), tally.camera) == cameras.end()) {
      cameras.push_back(tally.camera);
    }
  }
  return cameras;
}

const EventTally* find_tally(const JudgeReport& report, const std::string& rules,
                             const std::string& camera, const std::string& event) {
  for (const CameraTally& tally : report.tallies) {
    if (tally.rules != rules || tally.camera != camera) continue;
    const auto found = tally.events.find(event);
    return found == tally.events.end() ? nullptr : &found->second;
  }
  return nullptr;
}

// "0.987 of 120": F1, and the number of events.
std::string score_cell(const EventTally* tally) {
  if (tally == nullptr) return "";
  const std::optional<double> f1 = tally->f1();
  return f1 ? fmt::format("{:.3f} of {}", *f1, tally->happened()) : "";
}

std::string percent(int part, int whole) {
  return whole == 0 ? "" : fmt::format("{:.1f} %", 100.0 * part / whole);
}

}  // namespace

std::vector<std::string> books_in(const JudgeReport& report) {
  std::vector<std::string> books;
  for (const CameraTally& tally : report.tallies) {
    if (books.empty() || books.back() != tally.rules) books.push_back(tally.rules);
  }
  return books;
}

// The events of a rule book in the referee's order, with one row per camera.
TableRows event_rows(const JudgeReport& report, const std::string& rules) {
  TableRows rows = {{"event", "camera"}};
  for (const Measure& measure : measures()) rows.front().emplace_back(measure.head);
  for (const std::string& name : judged_names()) {
    for (const CameraTally& tally : report.tallies) {
      const auto found = tally.events.find(name);
      if (tally.rules != rules || found == tally.events.end()) continue;
      std::vector<std::string> cells = {needs_height(name) ? name + " (height)" : name,
                                        tally.camera};
      for (const Measure& measure : measures()) cells.push_back(text_of(measure, found->second));
      rows.push_back(cells);
    }
  }
  return rows;
}

// F1 of all events: one row per event and rule book, one column per camera.
TableRows scores_rows(const JudgeReport& report) {
  const std::vector<std::string> cameras = cameras_in(report);
  const std::vector<std::string> books = books_in(report);
  TableRows rows = {{"F1 of", "rules"}};
  rows.front().insert(rows.front().end(), cameras.begin(), cameras.end());
  for (const std::string& name : judged_names()) {
    for (const std::string& rules : books) {
      std::vector<std::string> cells = {needs_height(name) ? name + " (height)" : name, rules};
      bool is_known = false;
      for (const std::string& camera : cameras) {
        cells.push_back(score_cell(find_tally(report, rules, camera, name)));
        is_known = is_known || !cells.back().empty();
      }
      if (is_known) rows.push_back(cells);
    }
  }
  return rows;
}

TableRows last_touch_rows(const JudgeReport& report) {
  TableRows rows = {
      {"last touch at exits", "camera", "touched by", "right", "wrong", "unknown", "of"}};
  for (const CameraTally& tally : report.tallies) {
    for (std::size_t team = 0; team < tally.last_touch.size(); ++team) {
      const LastTouchTally& touch = tally.last_touch[team];
      const int all = touch.right + touch.wrong + touch.unknown;
      rows.push_back({tally.rules, tally.camera, team == 0 ? "a" : "b", percent(touch.right, all),
                      percent(touch.wrong, all), percent(touch.unknown, all), std::to_string(all)});
    }
  }
  return rows;
}

}  // namespace autoref::runner
