#include "judge/association.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace autoref::judge::ground_truth {
namespace {

using referee::Decision;
using referee::Event;

// Three frames: the time that the referee needs to confirm a fast kick.
constexpr double kAssociationSameTime_s = 0.05;

// Returns whether a call may be right for an event; a call with an unknown last touch fits several
// events.
bool may_be(std::string_view call, const TrueEvent& event) {
  if (call == "touch_line_unknown") return event.name == "throw_in";
  if (call == "goal_line_unknown") {
    return event.name == "corner_kick" || event.name == "goal_kick" || event.name == "aimless_kick";
  }
  return call == event.name || (!event.or_name.empty() && call == event.or_name);
}

bool is_unknown_touch(std::string_view call) { return call.ends_with("_line_unknown"); }

Side end_of(const Decision& decision) {
  return decision.finding.position_m && decision.finding.position_m->x() < 0 ? Side::kWest
                                                                             : Side::kEast;
}

std::optional<Side> offender_of(const Decision& decision) {
  switch (decision.finding.event) {
    case Event::kGoal:
      return decision.command ? std::optional(decision.command->side) : std::nullopt;
    case Event::kThrowIn:
      return decision.last_touch.side;
    case Event::kCornerKick:
      return end_of(decision);
    case Event::kGoalKick:
      return opponent_of(end_of(decision));
    case Event::kTouchLineUnknown:
      return std::nullopt;
    default:
      return decision.finding.offender;
  }
}

class Matcher {
 public:
  Matcher(const TrueEvents& true_events, const std::vector<JudgedCall>& calls, const Window& window)
      : true_events_(true_events),
        calls_(calls),
        window_(window),
        answered_(true_events.size(), false) {}

  // Greedy matching: each call, in order, takes the best event that is still free.
  std::vector<experiments::CallVerdict> associate() {
    for (const JudgedCall& call : calls_) evaluate(call);
    for (std::size_t i = 0; i < true_events_.size(); ++i) {
      if (true_events_[i].standing == Standing::kTrue && !answered_[i]) miss(true_events_[i]);
    }
    std::stable_sort(verdicts_.begin(), verdicts_.end(),
                     [](const experiments::CallVerdict& a, const experiments::CallVerdict& b) {
                       return a.time_s < b.time_s;
                     });
    return std::move(verdicts_);
  }

 private:
  // A call with an unknown last touch only claims that the ball left over this line, so the event
  // itself still counts as missed.
  void evaluate(const JudgedCall& call) {
    for (const Standing standing : {Standing::kTrue, Standing::kPrevented}) {
      const std::optional<std::size_t> found = nearest(call, standing, false);
      if (!found) continue;
      answered_[*found] = !is_unknown_touch(call.name);
      if (call.ended_play && answered_[*found]) right_ends_s_.push_back(call.time_s);
      add_right(call, true_events_[*found]);
      return;
    }
    add_wrong(call);
  }

  std::optional<std::size_t> nearest(const JudgedCall& call, Standing standing,
                                     bool is_answered) const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < true_events_.size(); ++i) {
      const TrueEvent& event = true_events_[i];
      if (event.standing != standing || answered_[i] != is_answered) continue;
      if (!may_be(call.name, event) || !is_in_window(call, event)) continue;
      if (!best || rank(call, event) < rank(call, true_events_[*best])) best = i;
    }
    return best;
  }

  static bool is_same_robot(const JudgedCall& call, const TrueEvent& event) {
    return call.robot && call.robot == event.robot;
  }

  // The cost of a match; lower is better. The same robot comes first, then the event nearest in
  // time.
  static std::pair<bool, double> rank(const JudgedCall& call, const TrueEvent& event) {
    return {!is_same_robot(call, event), std::abs(call.time_s - event.time_s)};
  }

  bool is_in_window(const JudgedCall& call, const TrueEvent& event) const {
    const double delay_s = call.time_s - event.time_s;
    const bool is_same_side = !call.offender || !event.offender || call.offender == event.offender;
    return is_same_side && delay_s >= -window_.lead_s && delay_s <= window_.lag_s;
  }

  void add_right(const JudgedCall& call, const TrueEvent& event) {
    experiments::CallVerdict verdict = verdict_on(event, experiments::CallOutcome::kRight);
    verdict.name = call.name;
    verdict.delay_s = call.time_s - event.time_s;
    verdict.is_early = event.standing == Standing::kPrevented;
    verdict.confidence = call.confidence;
    if (call.position_m && event.position_m) {
      verdict.error_m = (*call.position_m - *event.position_m).norm();
    }
    verdicts_.push_back(verdict);
  }

  void add_wrong(const JudgedCall& call) {
    experiments::CallVerdict verdict;
    verdict.name = call.name;
    verdict.outcome = experiments::CallOutcome::kWrong;
    verdict.time_s = call.time_s;
    verdict.offender = call.offender;
    verdict.is_in_air = call.is_in_air;
    verdict.confidence = call.confidence;
    verdict.is_borderline = nearest(call, Standing::kNearMiss, false).has_value();
    const std::optional<std::size_t> answered = nearest(call, Standing::kTrue, true);
    // A call that fits an event already called is a second call for it, not a false alarm.
    verdict.is_second = answered && (!call.robot || !true_events_[*answered].robot ||
                                     is_same_robot(call, true_events_[*answered]));
    verdicts_.push_back(verdict);
  }

  void miss(const TrueEvent& event) {
    // An event that happened just when a right call stopped play for another reason could no longer
    // be called.
    const bool is_overtaken = std::any_of(
        right_ends_s_.begin(), right_ends_s_.end(),
        [&](double end_s) { return std::abs(end_s - event.time_s) <= kAssociationSameTime_s; });
    verdicts_.push_back(verdict_on(event, is_overtaken ? experiments::CallOutcome::kOvertaken
                                                       : experiments::CallOutcome::kMissed));
  }

  static experiments::CallVerdict verdict_on(const TrueEvent& event,
                                             experiments::CallOutcome outcome) {
    experiments::CallVerdict verdict;
    verdict.name = event.name;
    verdict.outcome = outcome;
    verdict.time_s = event.time_s;
    verdict.offender = event.offender;
    verdict.is_borderline = event.is_borderline;
    verdict.is_in_air = event.is_in_air;
    return verdict;
  }

  const TrueEvents& true_events_;
  const std::vector<JudgedCall>& calls_;
  const Window& window_;
  std::vector<bool> answered_;
  std::vector<double> right_ends_s_;
  std::vector<experiments::CallVerdict> verdicts_;
};

}  // namespace

bool is_judged(Event event) {
  return referee::is_call(event) || event == Event::kMultipleFouls ||
         event == Event::kMultipleCards;
}

std::optional<JudgedCall> call_of(const Decision& decision) {
  if (!is_judged(decision.finding.event)) return std::nullopt;
  const bool ended_play =
      decision.from == referee::State::kRun && decision.to != referee::State::kRun;
  return JudgedCall{
      name_of(decision.finding.event),
      decision.time_s,
      offender_of(decision),
      decision.finding.robots.empty() ? std::nullopt
                                      : std::optional(decision.finding.robots.front()),
      decision.finding.position_m,
      ended_play,
      false,
      referee::is_call(decision.finding.event) ? std::optional(decision.finding.confidence)
                                               : std::nullopt};
}

std::vector<experiments::CallVerdict> associate(const TrueEvents& true_events,
                                                const std::vector<JudgedCall>& calls,
                                                const Window& window) {
  return Matcher(true_events, calls, window).associate();
}

}  // namespace autoref::judge::ground_truth
