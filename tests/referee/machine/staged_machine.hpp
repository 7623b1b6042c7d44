// The machine without the rest of the referee. Tests pass fouls to it directly and check for cards
// in every frame, at 60 Hz.
#pragma once

#include <optional>
#include <string_view>

#include "referee/machine/machine.hpp"
#include "referee/rules/rule.hpp"
namespace autoref::referee {

class StagedMachine {
 public:
  explicit StagedMachine(const Configuration& configuration, State machine_state = State::kRun)
      : configuration_(configuration) {
    state.machine_state = machine_state;
    if (machine_state == State::kRun) state.play_clock.start(0);
    state.signal.robots_allowed = configuration.robots;
  }

  // Passes a finding to the machine. Returns the transition's label, or an empty text if none was
  // taken.
  std::string_view put(const Finding& finding) {
    const Step taken = step(state, input(), finding);
    if (taken.transition == nullptr) return {};
    state = taken.state;
    return label_ = taken.label;
  }

  // A foul that is counted but does not stop play; without an offender, it counts against both
  // sides.
  std::string_view foul(std::optional<Side> offender) {
    Finding finding;
    finding.event =
        state.machine_state == State::kRun ? Event::kBotCrashUnique : Event::kBotTooFastInStop;
    finding.offender = offender;
    finding.is_foul = true;
    return put(finding);
  }

  void fouls(std::optional<Side> offender, int count) {
    for (int i = 0; i < count; ++i) foul(offender);
  }

  // Looks for cards as the referee does. Returns the label of the last transition taken.
  std::string_view look_for_cards() { return look_for(kCardsRule); }

  // The label of the last transition taken for the rule's findings; empty if there is none.
  std::string_view look_for(const Rule& rule) {
    std::string_view taken;
    for (const RuleSearch& search : rule.searches()) {
      if (!search.active_in.has(state.machine_state)) continue;
      const std::optional<Finding> found = search.find(state, input());
      if (!found) continue;
      last_found = *found;
      if (!put(*found).empty()) taken = label_;
    }
    return taken;
  }

  // Commits fouls until `count` cards have been shown for them.
  void fouls_for_cards(Side side, int count) {
    for (int i = 0; i < count * configuration_.rules.fouls_per_card; ++i) {
      foul(side);
      look_for_cards();
    }
  }

  // Puts robots 0 to `count` - 1 of each side in its own half.
  void line_up(int count) {
    for (const Side side : kSides) {
      for (int i = 0; i < count; ++i) {
        const Vec2 position_m(goal_sign(side) * 1.5, 0.3 * i);
        frame_.robots[side].push_back({i, position_m, Vec2(-goal_sign(side), 0)});
      }
    }
  }

  RobotObservation& robot(Side side, int number) {
    return frame_.robots[side][static_cast<std::size_t>(number)];
  }

  void wait(double seconds) { frame_.time_s += seconds; }
  double now_s() const { return frame_.time_s; }

  Finding last_found;  // by look_for()
  RefereeState state;

 private:
  RefereeInput input() const {
    return {configuration_, frame_, ball_, touch_, tracks_, requests_, frames_};
  }

  std::string_view label_;  // of the last transition taken
  Configuration configuration_;
  Frame frame_;
  std::optional<BallSight> ball_;
  LastTouch touch_;
  Tracks tracks_;
  PerSide<TeamRequests> requests_;
  FrameHistory frames_;
};

}  // namespace autoref::referee
