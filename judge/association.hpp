// Evaluates a referee's calls against the ground truth.
//
// A call is right if the same event happened at about the same time with the same side at fault: at
// most `lead_s` after the call and at most `lag_s` before it. Events and calls are matched one to
// one, preferably with the same robot, otherwise with the event nearest in time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/results/call_evaluation.hpp"
#include "judge/truth/true_event.hpp"
#include "referee/decision.hpp"

namespace autoref::judge::ground_truth {

// The league's evaluation of 2016 let the referee be up to 2 s early; with an exact ground truth, a
// shorter lead is enough. Vision at 60 Hz, and touches that are confirmed after four frames,
// account for a delay of 0.1 s.
struct Window {
  double lead_s = 0.25;
  double lag_s = 1.0;
};

struct JudgedCall {
  std::string_view name;
  double time_s = 0;
  std::optional<Side> offender;  // as in TrueEvent; nullopt if the call names none
  std::optional<RobotId> robot;
  std::optional<Vec2> position_m;
  bool ended_play = false;
  // Whether the ball was really in the air at the time of the call.
  bool is_in_air = false;
  std::optional<double> confidence = {};  // the referee's confidence; nullopt for cards
};

// Returns whether decisions on this event are evaluated: calls, and cards for every third foul.
bool is_judged(referee::Event event);

// Converts a decision to a call; nullopt if it is not evaluated.
std::optional<JudgedCall> call_of(const referee::Decision& decision);

// Returns the verdicts in order of time.
std::vector<experiments::CallVerdict> associate(const TrueEvents& true_events,
                                                const std::vector<JudgedCall>& calls,
                                                const Window& window = {});

}  // namespace autoref::judge::ground_truth
