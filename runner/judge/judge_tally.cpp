#include "runner/judge/judge_tally.hpp"

#include <algorithm>
#include <cmath>

#include "referee/event.hpp"
#include "runner/judge/truth/association.hpp"

namespace autoref::runner {
namespace {

std::optional<double> share(int part, int whole) {
  return whole == 0 ? std::nullopt : std::optional(static_cast<double>(part) / whole);
}

std::vector<std::string> names_of(bool (*is_one)(referee::Event)) {
  std::vector<std::string> names;
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (is_one(entry.event)) names.emplace_back(entry.name);
  }
  return names;
}

}  // namespace

std::optional<double> EventTally::precision() const { return share(right, calls()); }
std::optional<double> EventTally::recall() const { return share(right, happened()); }
std::optional<double> EventTally::f1() const { return share(2 * right, calls() + happened()); }

void EventTally::add(const ground_truth::Verdict& verdict) {
  const int borderline = verdict.is_borderline ? 1 : 0;
  in_air += verdict.is_in_air ? 1 : 0;
  switch (verdict.outcome) {
    case ground_truth::Outcome::kRight:
      ++right;
      early += verdict.is_early ? 1 : 0;
      delays_s.push_back(verdict.delay_s);
      if (verdict.error_m) errors_m.push_back(*verdict.error_m);
      return;
    case ground_truth::Outcome::kWrong:
      ++wrong;
      borderline_wrong += borderline;
      return;
    case ground_truth::Outcome::kMissed:
      ++missed;
      borderline_missed += borderline;
      return;
    case ground_truth::Outcome::kOvertaken:
      ++overtaken;
  }
}

std::optional<double> quantile(std::vector<double> sample, double share) {
  if (sample.empty()) return std::nullopt;
  std::sort(sample.begin(), sample.end());
  // The nearest-rank method.
  const auto rank = std::ceil(share * static_cast<double>(sample.size()));
  return sample[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

void CameraTally::add(const GameRecord& record, const CallEvaluation& evaluation) {
  ++games;
  if (record.status == Status::kVoid) {
    ++void_games;
    return;
  }
  for (const ground_truth::Verdict& verdict : evaluation.verdicts)
    events[verdict.name].add(verdict);
  for (std::size_t team = 0; team < last_touch.size(); ++team) {
    last_touch[team].right += evaluation.last_touch[team].right;
    last_touch[team].wrong += evaluation.last_touch[team].wrong;
    last_touch[team].unknown += evaluation.last_touch[team].unknown;
  }
}

std::vector<std::string> call_names() { return names_of(referee::is_call); }

std::vector<std::string> judged_names() { return names_of(ground_truth::is_judged); }

bool needs_height(std::string_view event) {
  return event == "chipped_goal" || event == "invalid_goal";
}

}  // namespace autoref::runner
