#include "referee/person/beside_person.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "referee/machine/readiness.hpp"
#include "referee/person/transitions_beside_person.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr double kGoesOn_s = 1_s;  // our choice
// Longest wait for the person's answer to a call; our choice.
constexpr double kLongestWait_s = 15_s;
constexpr double kCalledFor_s = 1_s;             // our choice: after this time, the event is a new
                                                 // one
constexpr double kFasterThanStop_mps = 0.3_mps;  // margin for the estimate of a robot's speed

// Whether a call of this event would stop play under the rule book.
bool would_stop_play(const RefereeInput& input, Event event) {
  return stops_play(event) ||
         (stops_play_by_book(event) && input.configuration.rules.fouls_stop_play);
}

// Whether the command differs from the one to which AutoRef's call would lead.
bool contradicts(const Finding& call, const Command& command) {
  const bool decides = starts_play(command.kind) || command.kind == CommandKind::kPrepareKickoff ||
                       command.kind == CommandKind::kPreparePenalty;
  return decides && command.kind != CommandKind::kNormalStart && command != call.restart;
}

}  // namespace

Configuration without_administration(Configuration configuration) {
  for (const RuleId rule : {RuleId::kCards, RuleId::kTimeouts, RuleId::kGoalLead})
    configuration.rules.in_force[rule] = false;
  return configuration;
}

BesidePerson::BesidePerson(const Configuration& configuration)
    : Official(configuration), has_person_(configuration.control == Control::kHuman) {}

std::optional<Finding> BesidePerson::follow(const RefereeSignal& given, const RefereeInput& input) {
  if (!has_person_) return std::nullopt;
  const bool is_new = is_new_command(given);
  given_ = given;
  if (is_new) return finding_of_command();
  take_values(state(), with_person(input));
  return std::nullopt;
}

bool BesidePerson::is_new_command(const RefereeSignal& given) const {
  return !given_ || given_->command_counter != given.command_counter ||
         given_->command != given.command;
}

Finding BesidePerson::finding_of_command() const {
  Finding finding;
  finding.event = Event::kCommandGiven;
  finding.rule = "paper 4.1, 5";
  const Command command = given_->command;
  finding.evidence = fmt::format("The referee sent {}", name_of(command));
  if (!calls_.empty() && contradicts(calls_.back().finding, command)) {
    const OwnCall& call = calls_.back();
    finding.evidence +=
        fmt::format(", which contradicts the call {} at {:.3f} s (next: {})",
                    name_of(call.finding.event), call.called_s, name_of(call.finding.restart));
  }
  finding.evidence += ".";
  return finding;
}

std::optional<Finding> BesidePerson::find_before_rules(const RefereeInput& input) {
  if (state().machine_state != State::kCalled) return std::nullopt;
  watch_signs(input);
  const double called_s = state().signal.command_time_s;
  const double now_s = input.time_s();
  // Since there was no signal, play was still on when the ball left the field.
  const bool has_left = !is_exit_called_ && is_ball_out(input);
  const bool goes_on =
      has_left || (has_passed(called_s, input.configuration.rules.stop_grace_s, now_s) &&
                   visibly_goes_on(now_s));
  if (!goes_on && !has_passed(called_s, kLongestWait_s, now_s)) return std::nullopt;
  Finding finding;
  finding.event = Event::kOverruled;
  finding.rule = "AutoRef";
  finding.value = now_s - called_s;
  finding.unit = "s";
  finding.evidence = fmt::format("No command has followed the call for {:.2f} s{}.", finding.value,
                                 goes_on ? ", and play goes on" : "");
  return finding;
}

void BesidePerson::watch_signs(const RefereeInput& input) {
  const bool is_on_field = input.ball && !is_ball_out(input);
  auto& since_s = goes_on_.ball_on_field_since_s;
  if (!is_on_field) since_s.reset();
  if (is_on_field && !since_s) since_s = input.time_s();
  const double fast_mps = input.configuration.rules.stop_speed_mps + kFasterThanStop_mps;
  for (const Side side : kSides) {
    const TrackedRobots& robots = input.tracks.robots[side];
    const bool is_fast =
        std::any_of(robots.begin(), robots.end(), [fast_mps](const TrackedRobot& robot) {
          return robot.is_seen && robot.velocity_mps.norm() > fast_mps;
        });
    if (is_fast) goes_on_.fast_s[side] = input.time_s();
  }
}

bool BesidePerson::visibly_goes_on(double now_s) const {
  const auto is_recent = [&](const std::optional<double>& fast_s) {
    return fast_s && now_s - *fast_s <= kGoesOn_s;
  };
  return goes_on_.ball_on_field_since_s &&
         has_passed(*goes_on_.ball_on_field_since_s, kGoesOn_s, now_s) &&
         is_recent(goes_on_.fast_s[Side::kWest]) && is_recent(goes_on_.fast_s[Side::kEast]);
}

std::optional<Finding> BesidePerson::find(const RefereeInput& input) {
  if (state().machine_state == State::kInit && !has_person_) return passed_by_itself(Event::kBegin);
  if (state().machine_state == State::kWaitStop) watch_ball(state(), input);
  return std::nullopt;
}

std::optional<Finding> BesidePerson::find_time_over(const RefereeInput& /*input*/) {
  return std::nullopt;
}

void BesidePerson::show_time(const RefereeInput& /*input*/) {
  if (given_) state().signal.stage_time_left_s = given_->stage_time_left_s;
}

RefereeInput BesidePerson::with_person(const RefereeInput& input) const {
  RefereeInput complete = input;
  if (given_) complete.given = &*given_;
  if (!calls_.empty()) complete.own_call = &calls_.back().finding;
  return complete;
}

std::optional<Step> BesidePerson::next(const RefereeInput& input, const Finding& finding) {
  if (state().machine_state == State::kRun && would_stop_play(input, finding.event)) {
    if (OwnCall* same = find_same_call(input, finding)) {
      same->found_s = input.time_s();
      return std::nullopt;
    }
    note_call(input, finding);
  }
  const std::array tables = {transitions_beside_person()};
  return if_taken(step(tables, state(), with_person(input), finding));
}

BesidePerson::OwnCall* BesidePerson::find_same_call(const RefereeInput& input,
                                                    const Finding& finding) {
  const bool ball_is_out = is_ball_out(input);
  const double now_s = input.time_s();
  const auto is_same = [&](const OwnCall& call) {
    if (now_s - call.found_s > kCalledFor_s) return false;
    if (call.ball_is_out && ball_is_out) return true;
    return call.finding.event == finding.event && call.finding.offender == finding.offender;
  };
  const auto same = std::find_if(calls_.begin(), calls_.end(), is_same);
  return same == calls_.end() ? nullptr : &*same;
}

void BesidePerson::note_call(const RefereeInput& input, const Finding& finding) {
  if (calls_.size() == calls_.capacity()) calls_.erase(calls_.begin());
  calls_.push_back({finding, input.time_s(), input.time_s(), is_ball_out(input)});
  is_exit_called_ = calls_.back().ball_is_out;
}

void BesidePerson::enter(const RefereeInput& input, const Finding& finding, Step step) {
  const State before = state().machine_state;
  Official::enter(input, finding, std::move(step));
  const State now = state().machine_state;
  if (now == State::kCalled && before != State::kCalled) goes_on_ = {};
  if (now != State::kRun) return;
  if (finding.event == Event::kOverruled) {
    for (OwnCall& call : calls_) call.found_s = input.time_s();
  } else if (finding.event == Event::kCommandGiven) {
    calls_.clear();
    is_exit_called_ = false;
  }
}

void BesidePerson::forget(const Frame& frame) {
  Official::forget(frame);
  goes_on_ = {};
}

}  // namespace autoref::referee
