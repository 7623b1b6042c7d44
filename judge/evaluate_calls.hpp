// Plays games and judges their referee by ground truth, and determines which of the last touches
// before the ball left the field were contested.
#pragma once

#include <span>
#include <string_view>

#include "experiments/results/call_evaluation.hpp"
#include "game/loop/game.hpp"
#include "judge/truth/true_event.hpp"
#include "sim/world.hpp"
#include "soccer/side.hpp"

namespace autoref::judge {

// A last touch is contested if both sides touched the ball within this time before the ball left
// the field.
inline constexpr double kContested_s = 0.1;

// Remembers when each side last touched the ball.
class SideTouches {
 public:
  // Call once per frame. `time_s` is the frame's time.
  void see(std::span<const sim::Touch> touches, double time_s);

  // Whether the last touch before the ball left the field at `exit_s` was contested.
  bool is_contested(double exit_s) const;

 private:
  static constexpr double kNever_s = -1e9;
  PerSide<double> latest_s_{{kNever_s, kNever_s}};
};

// The time at which the ball left the field before a call made at `call_s`: the time of the latest
// true exit, including one prevented by the end of play. If there was no exit in the second before
// the call, the time is that of the call.
double exit_time_s(const ground_truth::TrueEvents& true_events, double call_s);

struct EvaluatedGame {
  game::GameRecord record;
  experiments::CallEvaluation evaluation;
};

// Plays a game and compares its referee's calls with the true events. `observers` observe the same
// game. Throws like play().
EvaluatedGame evaluate_calls(const game::GameConfiguration& configuration,
                             const game::TeamMaker& make_team = game::make_registered_team,
                             game::Observers observers = {});

}  // namespace autoref::judge
