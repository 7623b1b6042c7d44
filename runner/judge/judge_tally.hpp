// What a referee's judgements come to, over many games.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/game/game.hpp"
#include "runner/results/call_evaluation.hpp"

namespace autoref::runner {

// One event, under one rule book and one camera. Called early counts as happened, called and right.
struct EventTally {
  int right = 0;
  int missed = 0;  // happened, and was not called
  int wrong = 0;   // called, and did not happen
  int early = 0;   // of the right ones: the call came before the event, which nobody then saw
  int borderline_missed = 0;
  int borderline_wrong = 0;
  int overtaken = 0;  // happened as another right call ended play; counts nowhere else
  int in_air = 0;     // of all of them: the ball flew
  std::vector<double> delays_s;
  std::vector<double> errors_m;

  int happened() const { return right + missed; }
  int calls() const { return right + wrong; }
  // None where nothing was called, or nothing happened, or neither.
  std::optional<double> precision() const;
  std::optional<double> recall() const;
  std::optional<double> f1() const;
  // The league's technical challenge of 2016: +1 for a right call, -2 for a wrong one.
  int score() const { return right - 2 * wrong; }

  void add(const ground_truth::Verdict& verdict);
};

// The smallest value that at least `share` of the sample do not exceed; none of an empty one.
std::optional<double> quantile(std::vector<double> sample, double share);

// All games under one rule book and one camera.
struct CameraTally {
  std::string rules;
  std::string camera;
  int games = 0;
  int void_games = 0;
  std::map<std::string, EventTally> events;  // by name
  std::array<LastTouchTally, 2> last_touch;  // by the team that truly touched it

  void add(const GameRecord& record, const CallEvaluation& evaluation);
};

// The referee's names of calls, in the order of referee/event.hpp; and of all that is judged.
std::vector<std::string> call_names();
std::vector<std::string> judged_names();

// Whether nobody can tell the event without knowing the ball's height.
bool needs_height(std::string_view event);

}  // namespace autoref::runner
