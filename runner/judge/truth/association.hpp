// Holds a referee's calls against what truly happened.
//
// A call is right where the same event happened, by the same side's fault, at about the same time:
// at most `lead_s` after the call and at most `lag_s` before it. Each event makes one call right,
// and each call answers one event: one of the same robot where there is one, else the nearest in
// time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "referee/decision.hpp"
#include "runner/judge/truth/true_event.hpp"
#include "runner/results/call_evaluation.hpp"

namespace autoref::runner::ground_truth {

// The league's evaluation of 2016 let the referee lead by 2 s; an exact truth allows less. Vision
// of 60 Hz and a touch that is sure after four frames explain 0.1 s.
struct Window {
  double lead_s = 0.25;
  double lag_s = 1.0;
};

struct Call {
  std::string_view name;
  double time_s = 0;
  std::optional<Side> offender;  // as in Happening; none: the call does not say
  std::optional<RobotId> robot;
  std::optional<Vec2> position_m;
  bool ended_play = false;
  bool is_in_air = false;  // the ball, truly, when the call came
};

// Whether decisions on the event are held against the truth: calls, and the card for every third
// foul.
bool is_judged(referee::Event event);

// What a decision says, in the truth's terms; none where it is not judged.
std::optional<Call> call_of(const referee::Decision& decision);

// In order of time.
std::vector<Verdict> associate(const TrueEvents& true_events, const std::vector<Call>& calls,
                               const Window& window = {});

}  // namespace autoref::runner::ground_truth
