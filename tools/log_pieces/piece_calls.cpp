#include "tools/log_pieces/piece_calls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/presets.hpp"

namespace autoref::tools {
namespace {

using referee::Event;
using referee::State;

constexpr double kSameTime_s = 0.1;
constexpr double kSignal_s = 0.15;  // the first referee packet of a log comes within this time
constexpr double kWarmUp_s = 0.5;   // time for the filters; evidence this early may or may not
                                    // suffice

// The time at which a call's evidence begins. For restarts, this is when the play began. For
// contacts, it follows from an upper bound on how long they last.
double evidence_from_s(const referee::Decision& d, double phase_from_s) {
  const auto before = [&d](double seconds) { return d.time_s - seconds; };
  switch (d.finding.event) {
    case Event::kThrowIn:
    case Event::kCornerKick:
    case Event::kGoalKick:
    case Event::kTouchLineUnknown:
    case Event::kGoalLineUnknown:
    case Event::kBotKickedBallTooFast:
    case Event::kChippedGoal:
      return d.last_touch.time_s > 0 ? d.last_touch.time_s : phase_from_s;
    case Event::kGoal:
      return before(2);
    case Event::kTooManyRobots:
      return before(d.finding.value);
    case Event::kBotCrashUnique:
    case Event::kBotCrashDrawn:
    case Event::kDefenderInDefenseArea:
    case Event::kDefenderInDefenseAreaPartially:
    case Event::kAttackerTouchedBallInDefenseArea:
      return before(0.3);
    case Event::kBotPushedBot:
    case Event::kBotDribbledBallTooFar:
      return before(4);
    case Event::kStuckBall:
    case Event::kNoProgressInGame:
    case Event::kKeeperHeldBall:
      return before(std::max(10.0, d.finding.value));
    default:
      return phase_from_s;
  }
}

bool is_same(const PieceCall& a, const PieceCall& b) {
  return a.event == b.event && a.side == b.side && std::abs(a.time_s - b.time_s) <= kSameTime_s;
}

bool is_exit(Event event) { return referee::entry_of(event).is_exit; }

// An exit whose last touch is unknown.
bool says_unknown(const PieceCall& call) {
  return call.event == Event::kTouchLineUnknown || call.event == Event::kGoalLineUnknown;
}

std::string text_of(const PieceCall& call) {
  return fmt::format("{:.3f} {} {}", call.time_s, referee::name_of(call.event),
                     call.side ? name_of(*call.side) : "-");
}

void say(const std::string& name, const char* what, const PieceCall& call) {
  fmt::print(stderr, "{}: {} {} (evidence from {:.3f})\n", name, what, text_of(call),
             call.evidence_from_s);
}

}  // namespace

void CallList::add(const referee::Decision& d) {
  const bool starts = d.to == State::kRun && (d.from != State::kRun || d.command);
  const bool stops = d.to == State::kWaitStop && d.from != State::kWaitStop;
  if (referee::is_call(d.finding.event)) {
    PieceCall call;
    call.event = d.finding.event;
    call.side = d.finding.offender;
    if (d.restart() && is_for_one_side(d.restart()->kind)) call.side = d.restart()->side;
    if (!d.finding.robots.empty()) call.robot = d.finding.robots.front();
    call.time_s = d.time_s;
    call.evidence_from_s = evidence_from_s(d, phase_from_s_);
    call.phase_from_s = phase_from_s_;
    call.in_stop = d.from == State::kWaitStop;
    calls_.push_back(call);
  }
  if (starts || stops) phase_from_s_ = d.time_s;
  if (d.from != State::kRun && d.to == State::kRun) changes_s_.push_back(d.time_s);
  if (d.from == State::kRun && d.to != State::kRun) changes_s_.push_back(d.time_s);
}

CallList CallList::later(double by_s) const {
  CallList moved = *this;
  for (PieceCall& call : moved.calls_) {
    call.time_s += by_s;
    call.evidence_from_s += by_s;
    call.phase_from_s += by_s;
  }
  return moved;
}

bool CallList::is_stopped_at(double time_s) const {
  const auto stopped = [this](double at_s) {
    const auto next = std::upper_bound(changes_s_.begin(), changes_s_.end(), at_s);
    return (next - changes_s_.begin()) % 2 == 0;
  };
  return stopped(time_s - kSameTime_s) || stopped(time_s + kSameTime_s);
}

void Tally::add(const CallList& whole, const CallList& judged, const Piece& piece) {
  ++pieces;
  const double first_s = piece.from_s + piece.joined_s;
  const double evidence_s = piece.from_s + (piece.from_s > 0 ? kWarmUp_s : 0);
  const auto& found = judged.calls();
  const auto counts = [&](const PieceCall& call) {
    return call.time_s > first_s && call.time_s < piece.to_s - kSameTime_s;
  };
  for (const PieceCall& call : whole.calls()) {
    if (!counts(call)) continue;
    const bool has_same = std::any_of(found.begin(), found.end(),
                                      [&](const PieceCall& other) { return is_same(call, other); });
    if (call.evidence_from_s >= evidence_s) {
      ++calls;
      agreed += has_same ? 1 : 0;
      if (!has_same) say(name, "missed", call);
      continue;
    }
    ++unknown_due;
    const bool is_answered = std::any_of(found.begin(), found.end(), [&](const PieceCall& other) {
      return std::abs(other.time_s - call.time_s) <= kSameTime_s && !says_unknown(other) &&
             (other.event == call.event || (is_exit(call.event) && is_exit(other.event)));
    });
    unknown += is_answered ? 0 : 1;
    same += has_same ? 1 : 0;
    if (is_answered && call.evidence_from_s < piece.from_s && !says_unknown(call))
      say(name, has_same ? "known without evidence" : "answered without evidence", call);
  }
  for (const PieceCall& call : found) {
    if (!counts(call)) continue;
    if (call.in_stop && !whole.is_stopped_at(call.time_s)) {
      ++unsignalled;
      say(name, "not in a stop:", call);
    }
    const auto& all = whole.calls();
    const bool has_same = std::any_of(all.begin(), all.end(), [&](const PieceCall& other) {
      const bool at_that_time = std::abs(call.time_s - other.time_s) <= kSameTime_s;
      return is_same(call, other) || (at_that_time && other.evidence_from_s < evidence_s);
    });
    if (has_same) continue;
    const bool was_made = std::any_of(all.begin(), all.end(), [&](const PieceCall& other) {
      return other.event == call.event && other.robot == call.robot && other.time_s < call.time_s &&
             other.phase_from_s < piece.from_s && other.time_s > call.time_s - 60;
    });
    if (call.phase_from_s <= piece.from_s + kSignal_s && was_made) {
      ++repeated;
      continue;
    }
    ++extra;
    say(name, "extra", call);
  }
}

Tally& Tally::operator+=(const Tally& other) {
  pieces += other.pieces;
  calls += other.calls;
  agreed += other.agreed;
  extra += other.extra;
  unknown_due += other.unknown_due;
  unknown += other.unknown;
  same += other.same;
  repeated += other.repeated;
  unsignalled += other.unsignalled;
  return *this;
}

std::string Tally::heading() {
  return "| rules | camera | logs | calls | the same | only in the log | agreement | evidence "
         "before "
         "the log | unknown | the same | made before the log | in a stop without a signal |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string Tally::row(const std::string& title) const {
  const int all = calls + extra;
  return fmt::format("| {} | {} | {} | {} | {} | {:.2f} % | {} | {} | {} | {} | {} |\n", title,
                     pieces, calls, agreed, extra, all > 0 ? 100.0 * agreed / all : 100.0,
                     unknown_due, unknown, same, repeated, unsignalled);
}

bool Tally::is_good() const {
  return unsignalled == 0 && static_cast<double>(agreed) >= 0.99 * (calls + extra);
}

std::vector<std::string> camera_names() { return sim::camera_preset_names(); }

}  // namespace autoref::tools
