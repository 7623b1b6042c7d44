// AutoRef when it works alongside a person: the person (or the game controller) commands the game,
// and AutoRef follows and makes its own calls.
//
// "AutoRef ... stops play at once" on its own call and then waits for the person's signal (paper,
// sections 4.1 and 5): it sends STOP and keeps observing. If no command follows and play visibly
// goes on, or 15 s pass, the call was overruled. Scores, cards and stages come from the person. If
// nobody commands the game, play is always on, and calls are only reported.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "referee/person/official.hpp"

namespace autoref::referee {

// Removes the rules on matters that a person decides: cards, timeouts and the end of the game.
Configuration without_administration(Configuration configuration);

class BesidePerson final : public Official {
 public:
  explicit BesidePerson(const Configuration& configuration);

  // Under Control::kNone, signals are ignored. The finding's evidence says whether the command
  // contradicts AutoRef's call.
  std::optional<Finding> follow(const RefereeSignal& given, const RefereeInput& input) override;

  // In CALLED: returns kOverruled once play visibly goes on, or 15 s after the call. Play visibly
  // goes on if the ball has been on the field for a second and, within that second, a robot of each
  // team has been faster than a stop allows; robots have 2 s to slow down. Play also goes on if the
  // ball leaves the field; if the person has given no signal, this exit is a separate event.
  std::optional<Finding> find_before_rules(const RefereeInput& input) override;
  std::optional<Finding> find(const RefereeInput& input) override;
  // Returns nothing, because the person keeps the time.
  std::optional<Finding> find_time_over(const RefereeInput& input) override;

  // A finding leads to no step if its event has already been called in this play. The same event by
  // the same side counts as already called until it has not been found for a second. So does any
  // event while the ball stays outside the field. If a finding does lead to a step, its event
  // counts as called from now on.
  std::optional<Step> next(const RefereeInput& input, const Finding& finding) override;
  void enter(const RefereeInput& input, const Finding& finding, Step step) override;
  void show_time(const RefereeInput& input) override;

  bool is_exit_called() const override { return is_exit_called_; }
  void note_return() override { is_exit_called_ = false; }
  void forget(const Frame& frame) override;

 private:
  // A call that AutoRef made itself and that waits for the person's answer. It is kept afterwards,
  // so that the same event is not called twice.
  struct OwnCall {
    Finding finding;
    double called_s = 0;
    double found_s = 0;        // when the rule last found the event
    bool ball_is_out = false;  // whether the ball was outside the field at the call
  };

  // Signs that play continues despite a call.
  struct PlayGoesOn {
    std::optional<double> ball_on_field_since_s;
    PerSide<std::optional<double>> fast_s;  // when a robot last was faster than a stop allows
  };

  RefereeInput with_person(const RefereeInput& input) const;
  bool is_new_command(const RefereeSignal& given) const;
  Finding finding_of_command() const;
  OwnCall* find_same_call(const RefereeInput& input, const Finding& finding);
  void note_call(const RefereeInput& input, const Finding& finding);
  void watch_signs(const RefereeInput& input);
  bool visibly_goes_on(double now_s) const;

  bool has_person_;
  std::optional<RefereeSignal> given_;  // the person's last signal
  // AutoRef's calls in the current play, oldest first.
  boost::container::static_vector<OwnCall, 8> calls_;
  bool is_exit_called_ = false;  // the ball's exit has been called, and the ball has not come back
  PlayGoesOn goes_on_;           // used in CALLED
};

}  // namespace autoref::referee
