// AutoRef as an official: holds the machine's state, and takes findings to the machine.
//
// This class officiates alone: it commands the game (paper, section 4.3) and keeps its time. See
// person/ for a game that somebody else commands.
#pragma once

#include <optional>

#include "referee/configuration.hpp"
#include "referee/finding.hpp"
#include "referee/machine/machine.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

class Official {
 public:
  explicit Official(const Configuration& configuration);
  virtual ~Official() = default;

  // Rules write their own records into the state.
  RefereeState& state() { return state_; }
  const RefereeState& state() const { return state_; }

  // Takes note of the signal of whoever commands the game. Returns a finding if it contains a new
  // command.
  virtual std::optional<Finding> follow(const RefereeSignal& given, const RefereeInput& input);

  // What the machine's state waits for: before the rules of a frame, after them, and at its end.
  virtual std::optional<Finding> find_before_rules(const RefereeInput& input);
  virtual std::optional<Finding> find(const RefereeInput& input);
  virtual std::optional<Finding> find_time_over(const RefereeInput& input);

  // The step that a finding leads to from the current state; without a transition if it leads to
  // none.
  virtual Step next(const RefereeInput& input, const Finding& finding);
  // Takes that step.
  virtual void enter(const RefereeInput& input, const Finding& finding, Step step);

  // Shows the time that is left in the signal.
  virtual void show_time(const RefereeInput& input);

  // Whether the ball is still outside the field after its exit was called, though play is on.
  virtual bool is_exit_called() const { return false; }
  // Takes note that it is back.
  virtual void note_return() {}

  // Takes note of a long gap before this frame: the rules' records begin afresh.
  virtual void forget(const Frame& frame);

 private:
  RefereeState state_;
};

// A finding without evidence: the first frame, or the end of a briefly sent command.
Finding passed_by_itself(Event event);

}  // namespace autoref::referee
