// AutoRef as an official: holds the machine's state, and passes findings to the machine. The
// referee calls it in each frame.
//
// This class is for games without a person: it commands the game (paper, section 4.3) and keeps the
// time. If somebody else commands the game, a derived class takes its place (person/).
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/machine.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_configuration.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

class Official {
 public:
  explicit Official(const Configuration& configuration);
  virtual ~Official() = default;

  // Rules keep their own records in the state.
  RefereeState& state() { return state_; }
  const RefereeState& state() const { return state_; }

  // Records a signal from whoever commands the game. Returns a finding if it contains a new
  // command.
  virtual std::optional<Finding> follow(const RefereeSignal& given, const RefereeInput& input);

  // Looks for the event that the machine's current state waits for. Called before the rules of each
  // frame.
  virtual std::optional<Finding> find_before_rules(const RefereeInput& input);
  // Looks for further events. Called after the rules, if the rules have changed neither the state
  // nor the command.
  virtual std::optional<Finding> find(const RefereeInput& input);
  // Looks for the end of a half or game. Called at the end of each frame.
  virtual std::optional<Finding> find_time_over(const RefereeInput& input);

  // Records a finding. Returns the step to which it leads from the current state; nullopt if it
  // leads to none.
  virtual std::optional<Step> next(const RefereeInput& input, const Finding& finding);
  // Takes the step that next() returned.
  virtual void enter(const RefereeInput& input, const Finding& finding, Step step);

  // Shows in the signal what is left of the half, of cards and of timeouts, and the fouls so far.
  virtual void show_time(const RefereeInput& input);

  // Whether the ball has stayed outside the field since its exit was called, although play is on.
  virtual bool is_exit_called() const { return false; }
  // Records that the ball is back on the field.
  virtual void note_return() {}

  // Discards the rules' records. Called if there is a long gap before this frame.
  virtual void forget(const Frame& frame);

 private:
  RefereeState state_;
};

// The given step, or nullopt if no transition applies.
std::optional<Step> if_taken(Step step);

// A finding without evidence, for the first frame or the end of a briefly sent command.
Finding passed_by_itself(Event event);

// Whether the ball was last seen outside the field.
bool is_ball_out(const RefereeInput& input);

}  // namespace autoref::referee
