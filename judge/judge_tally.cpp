#include "judge/judge_tally.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/statistics/interval.hpp"
#include "judge/association.hpp"
#include "referee/event.hpp"

namespace autoref::judge {
namespace {

// Rows store times with four decimals.
constexpr double kTimeResolution_s = 1e-4;

// The numbers that are summed when tallies are added.
constexpr std::array<int EventTally::*, 9> kEventCounts = {&EventTally::right,
                                                           &EventTally::missed,
                                                           &EventTally::wrong,
                                                           &EventTally::early,
                                                           &EventTally::before,
                                                           &EventTally::borderline_missed,
                                                           &EventTally::borderline_wrong,
                                                           &EventTally::overtaken,
                                                           &EventTally::in_air};
constexpr std::array<int experiments::LastTouchTally::*, 3> kTouchCounts = {
    &experiments::LastTouchTally::right, &experiments::LastTouchTally::wrong,
    &experiments::LastTouchTally::unknown};

template <typename Tally, std::size_t size>
void add_counts(const std::array<int Tally::*, size>& counts, const Tally& other, Tally& sum) {
  for (const auto count : counts) sum.*count += other.*count;
}

void add_touches(const std::array<experiments::LastTouchTally, 2>& other,
                 std::array<experiments::LastTouchTally, 2>& sum) {
  for (std::size_t team = 0; team < sum.size(); ++team) {
    add_counts(kTouchCounts, other[team], sum[team]);
  }
}

void append(const std::vector<double>& more, std::vector<double>& values) {
  values.insert(values.end(), more.begin(), more.end());
}

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

void Reliability::add(const experiments::CallVerdict& verdict) {
  if (!verdict.confidence) return;
  std::size_t index = kFrom.size() - 1;
  while (index > 0 && *verdict.confidence < kFrom[index]) --index;
  ReliabilityBand& band = bands_[index];
  ++band.calls;
  band.right += verdict.outcome == experiments::CallOutcome::kRight ? 1 : 0;
  band.confidence_sum += *verdict.confidence;
}

void Reliability::add(const Reliability& other) {
  for (std::size_t i = 0; i < bands_.size(); ++i) {
    bands_[i].calls += other.bands_[i].calls;
    bands_[i].right += other.bands_[i].right;
    bands_[i].confidence_sum += other.bands_[i].confidence_sum;
  }
}

std::optional<double> EventTally::precision() const { return share(right, calls()); }
std::optional<double> EventTally::recall() const { return share(right, happened()); }
std::optional<double> EventTally::f1() const { return share(2 * right, calls() + happened()); }

std::optional<experiments::Interval> EventTally::precision_interval() const {
  return experiments::wilson_interval(right, calls());
}

std::optional<experiments::Interval> EventTally::recall_interval() const {
  return experiments::wilson_interval(right, happened());
}

std::optional<experiments::Interval> EventTally::f1_interval() const {
  return experiments::f1_interval(right, wrong, missed);
}

void EventTally::add(const experiments::CallVerdict& verdict) {
  const int borderline = verdict.is_borderline ? 1 : 0;
  in_air += verdict.is_in_air ? 1 : 0;
  switch (verdict.outcome) {
    case experiments::CallOutcome::kRight:
      ++right;
      early += verdict.is_early ? 1 : 0;
      before += is_before_event(verdict) ? 1 : 0;
      delays_s.push_back(verdict.delay_s);
      if (verdict.error_m) errors_m.push_back(*verdict.error_m);
      return;
    case experiments::CallOutcome::kWrong:
      ++wrong;
      borderline_wrong += borderline;
      return;
    case experiments::CallOutcome::kMissed:
      ++missed;
      borderline_missed += borderline;
      return;
    case experiments::CallOutcome::kOvertaken:
      ++overtaken;
  }
}

void EventTally::add(const EventTally& other) {
  add_counts(kEventCounts, other, *this);
  append(other.delays_s, delays_s);
  append(other.errors_m, errors_m);
}

bool is_before_event(const experiments::CallVerdict& verdict) {
  return verdict.outcome == experiments::CallOutcome::kRight && !verdict.is_early &&
         verdict.delay_s <= -kTimeResolution_s;
}

std::optional<double> quantile(std::vector<double> sample, double share) {
  if (sample.empty()) return std::nullopt;
  std::sort(sample.begin(), sample.end());
  // The nearest-rank method.
  const auto rank = std::ceil(share * static_cast<double>(sample.size()));
  return sample[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

void CameraTally::add(const game::GameRecord& record,
                      const experiments::CallEvaluation& evaluation) {
  ++games;
  if (record.status == game::Status::kVoid) {
    ++void_games;
    return;
  }
  for (const experiments::CallVerdict& verdict : evaluation.verdicts) {
    events[verdict.name].add(verdict);
    reliability.add(verdict);
  }
  add_touches(evaluation.last_touch, last_touch);
  add_touches(evaluation.contested_touch, contested_touch);
}

void CameraTally::add(const CameraTally& other) {
  games += other.games;
  void_games += other.void_games;
  for (const auto& [name, tally] : other.events) events[name].add(tally);
  add_touches(other.last_touch, last_touch);
  add_touches(other.contested_touch, contested_touch);
  reliability.add(other.reliability);
}

EventTally touch_tally(const std::array<experiments::LastTouchTally, 2>& by_team) {
  EventTally tally;
  for (const experiments::LastTouchTally& touch : by_team) {
    tally.right += touch.right;
    tally.wrong += touch.wrong;
    tally.missed += touch.wrong + touch.unknown;
  }
  return tally;
}

std::vector<std::string> call_names() { return names_of(referee::is_call); }

std::vector<std::string> judged_names() { return names_of(ground_truth::is_judged); }

bool needs_height(std::string_view event) {
  return event == "chipped_goal" || event == "invalid_goal";
}

}  // namespace autoref::judge
