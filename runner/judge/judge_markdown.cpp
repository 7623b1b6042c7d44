// The judge's report for people.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "runner/judge/judge_measures.hpp"
#include "runner/judge/judge_report.hpp"

namespace autoref::runner {
namespace {

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
  for (const Measure& measure : measures()) heads.emplace_back(measure.head);
  std::string text = markdown_head(heads, 2);
  for (const std::string& name : judged_names()) {
    for (const CameraTally& tally : report.tallies) {
      const auto found = tally.events.find(name);
      if (tally.rules != rules || found == tally.events.end()) continue;
      std::vector<std::string> cells = {needs_height(name) ? name + " (height)" : name,
                                        tally.camera};
      for (const Measure& measure : measures()) cells.push_back(measure.text(found->second));
      text += markdown_row(cells);
    }
  }
  return text;
}

std::vector<std::string> books_in(const JudgeReport& report) {
  std::vector<std::string> books;
  for (const CameraTally& tally : report.tallies) {
    if (books.empty() || books.back() != tally.rules) books.push_back(tally.rules);
  }
  return books;
}

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

// "0.987 of 120": F1, and how often the event happened.
std::string score_cell(const EventTally* tally) {
  if (tally == nullptr) return "";
  const std::optional<double> f1 = tally->f1();
  return f1 ? fmt::format("{:.3f} of {}", *f1, tally->happened()) : "";
}

// Every event at a glance: books below, cameras beside each other.
std::string scores_table(const JudgeReport& report, const std::vector<std::string>& books) {
  const std::vector<std::string> cameras = cameras_in(report);
  std::vector<std::string> heads = {"F1 of", "rules"};
  heads.insert(heads.end(), cameras.begin(), cameras.end());
  std::string text = markdown_head(heads, 2);
  for (const std::string& name : judged_names()) {
    for (const std::string& rules : books) {
      std::vector<std::string> cells = {needs_height(name) ? name + " (height)" : name, rules};
      bool is_known = false;
      for (const std::string& camera : cameras) {
        cells.push_back(score_cell(find_tally(report, rules, camera, name)));
        is_known = is_known || !cells.back().empty();
      }
      if (is_known) text += markdown_row(cells);
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
      text += markdown_row({tally.rules, tally.camera, team == 0 ? "a" : "b",
                            percent(touch.right, all), percent(touch.wrong, all),
                            percent(touch.unknown, all), std::to_string(all)});
    }
  }
  return text;
}

std::string list(const std::string& what, const std::vector<std::string>& lines) {
  constexpr std::size_t kMost = 20;
  std::string text =
      fmt::format("{}: {}\n", what, lines.empty() ? "none" : std::to_string(lines.size()));
  for (std::size_t i = 0; i < std::min(kMost, lines.size()); ++i) text += "- " + lines[i] + "\n";
  if (lines.size() > kMost) text += fmt::format("- and {} more\n", lines.size() - kMost);
  return text;
}

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string markdown_of(const JudgeReport& report) {
  const std::vector<std::string> books = books_in(report);
  std::string text = scores_table(report, books) + "\n" + last_touch_table(report) + "\n";
  text += list("events called twice", report.second_calls);
  text += list("calls that need play while there was none", report.calls_in_stop);
  text += list("void games", report.void_games);
  text +=
      fmt::format("referee transitions never used: {}\n", joined(report.transitions_never_used));
  text += fmt::format("events never seen: {}\n", joined(report.rules_never_seen));
  for (const std::string& rules : books) {
    text += fmt::format("\nrules: {}, {} games under each camera\n\n{}", rules,
                        report.tallies.front().games, events_table(report, rules));
  }
  return text;
}

}  // namespace autoref::runner
