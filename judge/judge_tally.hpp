// Totals of a referee's evaluation over many games, and the reliability of its confidence.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/results/call_evaluation.hpp"
#include "experiments/statistics/interval.hpp"
#include "game/loop/game.hpp"

namespace autoref::judge {

// The tally of calls with similar confidence.
struct ReliabilityBand {
  int calls = 0;
  int right = 0;
  double confidence_sum = 0;
};

// The reliability of the referee's confidence: among calls with a confidence of 0.9, 90 % should be
// right.
class Reliability {
 public:
  // Lower ends of the bands; each band ends where the next one begins, and the last one ends at 1.
  static constexpr std::array kFrom = {0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98};

  // Verdicts without a confidence do not count.
  void add(const experiments::CallVerdict& verdict);
  void add(const Reliability& other);

  const ReliabilityBand& band(std::size_t index) const { return bands_[index]; }

 private:
  std::array<ReliabilityBand, kFrom.size()> bands_;
};

// Events that happened less often are rare: their measures are uncertain by several hundredths.
inline constexpr int kRareEvents = 100;

// The tally of one event with one rule book and one camera. If a call is early, the event counts as
// happened, called and right.
struct EventTally {
  int right = 0;
  int missed = 0;  // happened but was not called
  int wrong = 0;   // called but did not happen
  int early = 0;   // right calls of events that could no longer happen, since play was stopped
  int before = 0;  // right calls that came before an event that did happen
  int borderline_missed = 0;
  int borderline_wrong = 0;
  int overtaken = 0;  // happened when another right call stopped play; not counted elsewhere
  int in_air = 0;     // events and wrong calls with the ball in the air
  std::vector<double> delays_s;
  std::vector<double> errors_m;

  int happened() const { return right + missed; }
  int calls() const { return right + wrong; }
  bool is_rare() const { return happened() < kRareEvents; }
  // nullopt if undefined: precision if nothing was called, recall if nothing happened, F1 if
  // nothing was called and nothing happened.
  std::optional<double> precision() const;
  std::optional<double> recall() const;
  std::optional<double> f1() const;
  // The 95 % confidence intervals of precision, recall and F1: Wilson's, and f1_interval()
  // (interval.hpp) for F1.
  std::optional<experiments::Interval> precision_interval() const;
  std::optional<experiments::Interval> recall_interval() const;
  std::optional<experiments::Interval> f1_interval() const;
  // Score in the league's technical challenge of 2016: +1 for a right call, -2 for a wrong one.
  int score() const { return right - 2 * wrong; }

  void add(const experiments::CallVerdict& verdict);
  void add(const EventTally& other);
};

// Whether a right call came before its event. Calls do not count if they prevented the event by
// stopping play (CallVerdict::is_early).
bool is_before_event(const experiments::CallVerdict& verdict);

// The smallest value that is not exceeded by at least the fraction `share` of the sample; nullopt
// if the sample is empty.
std::optional<double> quantile(std::vector<double> sample, double share);

// The name of the rule book in tallies pooled over all rule books.
inline constexpr const char* kAllRules = "all";

// The tallies of all games with one master seed, one rule book and one camera.
struct CameraTally {
  std::string seeds;  // name of the master seed
  std::string rules;
  std::string camera;
  int games = 0;
  int void_games = 0;
  std::map<std::string, EventTally> events;  // tallies by event name
  // Last touches, indexed by the team that actually touched the ball: for all exits of the ball,
  // and for contested ones.
  std::array<experiments::LastTouchTally, 2> last_touch;
  std::array<experiments::LastTouchTally, 2> contested_touch;
  Reliability reliability;

  void add(const game::GameRecord& record, const experiments::CallEvaluation& evaluation);
  void add(const CameraTally& other);
};

// The last touches of both teams, counted like an event. A touch that was attributed to the wrong
// team counts as missed and as a wrong call. A touch that was attributed to nobody counts as
// missed.
EventTally touch_tally(const std::array<experiments::LastTouchTally, 2>& by_team);

// The names of the referee's calls, in the order of referee/event.hpp, and the names of all
// evaluated events.
std::vector<std::string> call_names();
std::vector<std::string> judged_names();

// Returns whether recognising the event requires the ball's height.
bool needs_height(std::string_view event);

}  // namespace autoref::judge
