// Totals of a referee's evaluation over many games.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/game/game.hpp"
#include "runner/results/call_evaluation.hpp"

namespace autoref::runner {

// One event with one rule book and one camera. An early call counts as happened, called and right.
struct EventTally {
  int right = 0;
  int missed = 0;  // happened but was not called
  int wrong = 0;   // called but did not happen
  int early = 0;   // right calls that came before the event
  int borderline_missed = 0;
  int borderline_wrong = 0;
  int overtaken = 0;  // happened when another right call ended play; not counted elsewhere
  int in_air = 0;     // events and wrong calls with the ball in the air
  std::vector<double> delays_s;
  std::vector<double> errors_m;

  int happened() const { return right + missed; }
  int calls() const { return right + wrong; }
  // nullopt if undefined: nothing was called, nothing happened, or neither.
  std::optional<double> precision() const;
  std::optional<double> recall() const;
  std::optional<double> f1() const;
  // Score in the league's technical challenge of 2016: +1 for a right call, -2 for a wrong one.
  int score() const { return right - 2 * wrong; }

  void add(const ground_truth::Verdict& verdict);
};

// The smallest value that at least the fraction `share` of the sample does not exceed; nullopt if
// the sample is empty.
std::optional<double> quantile(std::vector<double> sample, double share);

// All games with one rule book and one camera.
struct CameraTally {
  std::string rules;
  std::string camera;
  int games = 0;
  int void_games = 0;
  std::map<std::string, EventTally> events;  // by name
  std::array<LastTouchTally, 2> last_touch;  // by the team that truly touched the ball

  void add(const GameRecord& record, const CallEvaluation& evaluation);
};

// The referee's names of calls, in the order of referee/event.hpp, and of all evaluated events.
std::vector<std::string> call_names();
std::vector<std::string> judged_names();

// Returns whether recognising the event requires the ball's height.
bool needs_height(std::string_view event);

}  // namespace autoref::runner
