#include "referee/machine/machine.hpp"

#include <array>

namespace autoref::referee {
namespace {

// clang-format off
constexpr std::array kInFigure = {
  Transition{"begin", State::kInit, Event::kBegin, kAlways, kBeginGames,
        State::kWaitStart, "paper 4.3; STOP: 2016", "D1"},
  Transition{"clients_moved", State::kWaitStart, Event::kRobotsMoved, kAlways, kPrepareFirstKickoff,
        State::kWaitStop, "paper 4.3, 4.4", "D5"},
  Transition{"start_timeout", State::kWaitStart, Event::kStartTimeout, kAlways, kPrepareFirstKickoff,
        State::kWaitStop, "ours", "D2"},
  Transition{"prepare", State::kWaitStop, Event::kReady, kNextIsPreparation, kSendPreparation,
        State::kWaitStop, "2016", "D3, D13"},
  Transition{"prepare_late", State::kWaitStop, Event::kReadyTimeout, kNextIsPreparation, kSendPreparation,
        State::kWaitStop, "2016", "D3, D13"},
  Transition{"start", State::kWaitStop, Event::kReady, kNextStartsPlay, kStartPlay,
        State::kRun, "paper 4.2, 4.4", "D13"},
  Transition{"start_late", State::kWaitStop, Event::kReadyTimeout, kNextStartsPlay, kStartPlay,
        State::kRun, "paper 4.2, a fixed timeout", "D13"},
  Transition{"goal", State::kRun, Event::kGoal, kAlways, kAwardGoal,
        State::kDelayWait, "paper 4.2, 4.3", ""},
  Transition{"throw_in", State::kRun, Event::kThrowIn, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2", ""},
  Transition{"corner_kick", State::kRun, Event::kCornerKick, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2", ""},
  Transition{"goal_kick", State::kRun, Event::kGoalKick, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2", ""},
  Transition{"touch_line_unknown", State::kRun, Event::kTouchLineUnknown, kAlways, kStopPlay,
        State::kWaitStop, "ours", "D14"},
  Transition{"attacker_near_area", State::kRun, Event::kAttackerNearArea, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2; Laws", "D9"},
  Transition{"restart_not_taken", State::kRun, Event::kRestartNotTaken, kAlways, kStopPlay,
        State::kWaitStop, "2016, Laws", "D10"},
  Transition{"stuck_ball", State::kRun, Event::kStuckBall, kAlways, kStopPlay,
        State::kWaitStop, "2016, Laws", "D11"},
  Transition{"signalled", State::kDelayWait, Event::kSignalled, kDuringGame, kStopAfterSignal,
        State::kWaitStop, "paper 4.3; STOP: 2016", "D4"},
};

constexpr std::array kOutsideFigure = {
  Transition{"half_over", std::nullopt, Event::kHalfOver, kAlways, kEndHalf,
        State::kDelayWait, "paper 4.2, 4.3; HALT: ours", "D12"},
  Transition{"next_half", State::kDelayWait, Event::kSignalled, kBetweenHalves, kBeginNextHalf,
        State::kWaitStop, "paper 4.2, 4.3; Laws", "D12"},
  Transition{"game_over", std::nullopt, Event::kGameOver, kGameWasLast, kEndGame,
        State::kOver, "paper 4.2", ""},
  Transition{"game_over_next", std::nullopt, Event::kGameOver, kNewGameFollows, kEndGame,
        State::kDelayWait, "paper 4.2; HALT: ours", "D12"},
  Transition{"new_game", State::kDelayWait, Event::kSignalled, kAfterGame, kBeginNewGame,
        State::kWaitStop, "paper 4.2", ""},
};
constexpr std::array kBeyondPaper = {
  Transition{"no_progress", State::kRun, Event::kNoProgress, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"kick_speed", State::kRun, Event::kKickSpeed, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"chip_goal", State::kRun, Event::kChipGoal, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"goal_invalid", State::kRun, Event::kGoalInvalid, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"indirect_goal", State::kRun, Event::kIndirectGoal, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"free_kick_own_goal", State::kRun, Event::kFreeKickOwnGoal, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"defender_in_area", State::kRun, Event::kDefenderInArea, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"defender_partly_in_area", State::kRun, Event::kDefenderPartlyInArea, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"attacker_in_area", State::kRun, Event::kAttackerInArea, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"double_touch", State::kRun, Event::kDoubleTouch, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"dribbling", State::kRun, Event::kDribbling, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"keeper_holding", State::kRun, Event::kKeeperHolding, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"pushing", State::kRun, Event::kPushing, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"kickoff_positions", State::kRun, Event::kKickoffPositions, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"penalty_positions", State::kRun, Event::kPenaltyPositions, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"penalty_failed", State::kRun, Event::kPenaltyFailed, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"aimless_kick", State::kRun, Event::kAimlessKick, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"offside", State::kRun, Event::kOffside, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"goal_line_unknown", State::kRun, Event::kGoalLineUnknown, kAlways, kStopPlay,
        State::kWaitStop, "ours", "D14"},
  Transition{"restart_distance", State::kRun, Event::kRestartDistance, kFoulsStopPlay, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"restart_distance_noted", State::kRun, Event::kRestartDistance, kFoulsAreNoted, kNoteFoul,
        State::kRun, "rule book", ""},
  Transition{"crash", State::kRun, Event::kCrash, kFoulsStopPlay, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"crash_noted", State::kRun, Event::kCrash, kFoulsAreNoted, kNoteFoul,
        State::kRun, "rule book", ""},
  Transition{"crash_drawn", State::kRun, Event::kCrashDrawn, kAlways, kNoteFoul,
        State::kRun, "rule book", ""},
  Transition{"attacker_stays_near_area", State::kRun, Event::kAttackerStaysNearArea, kAlways, kNoteFoul,
        State::kRun, "rule book", ""},
  Transition{"attacker_stays_near_area_stopped", State::kWaitStop, Event::kAttackerStaysNearArea, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
  Transition{"stop_speed", State::kWaitStop, Event::kStopSpeed, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
  Transition{"stop_distance", State::kWaitStop, Event::kStopDistance, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
  Transition{"placement_interference", State::kWaitStop, Event::kPlacementInterference, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
  Transition{"too_many_robots", State::kRun, Event::kTooManyRobots, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"too_many_robots_stopped", State::kWaitStop, Event::kTooManyRobots, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
};
// clang-format on

bool leads_on(const Transition& transition, const RefereeState& state, const RefereeInput& input,
              Event event) {
  return transition.event == event &&
         (!transition.from || *transition.from == state.machine_state) &&
         transition.guard.holds(state, input.configuration);
}

void follow_play(RefereeState& state, State before, double now_s) {
  if (before == state.machine_state) return;
  if (before == State::kRun) state.play_clock.stop(now_s);
  if (state.machine_state == State::kRun) state.play_clock.start(now_s);
}

const Transition* find_transition(const RefereeState& state, const RefereeInput& input,
                                  Event event) {
  for (const std::span<const Transition> transitions : all_transitions()) {
    for (const Transition& transition : transitions) {
      if (leads_on(transition, state, input, event)) return &transition;
    }
  }
  return nullptr;
}

}  // namespace

std::span<const Transition> transitions_in_figure() { return kInFigure; }
std::span<const Transition> transitions_outside_figure() { return kOutsideFigure; }
std::span<const Transition> transitions_beyond_paper() { return kBeyondPaper; }

std::array<std::span<const Transition>, 4> all_transitions() {
  return {transitions_of_administration(), transitions_in_figure(), transitions_outside_figure(),
          transitions_beyond_paper()};
}

Step step(const RefereeState& state, const RefereeInput& input, const Finding& finding) {
  Step taken{state, find_transition(state, input, finding.event), std::nullopt};
  if (taken.transition == nullptr) return taken;
  taken.transition->action.take(taken.state, input, finding);
  taken.state.machine_state = taken.transition->to;
  follow_play(taken.state, state.machine_state, input.time_s());
  if (taken.state.signal.command_counter != state.signal.command_counter) {
    taken.sent = taken.state.signal.command;
  }
  return taken;
}

}  // namespace autoref::referee
