#include "referee/machine/machine.hpp"

#include <array>

namespace autoref::referee {
namespace {

// clang-format off
constexpr std::array kInFigure = {
  Arrow{"begin", State::kInit, Event::kBegin, kAlways, kBeginGames,
        State::kWaitStart, "paper 4.3; STOP: 2016", "D1"},
  Arrow{"clients_moved", State::kWaitStart, Event::kRobotsMoved, kAlways, kPrepareFirstKickoff,
        State::kWaitStop, "paper 4.3, 4.4", "D5"},
  Arrow{"start_timeout", State::kWaitStart, Event::kStartTimeout, kAlways, kPrepareFirstKickoff,
        State::kWaitStop, "ours", "D2"},
  Arrow{"prepare", State::kWaitStop, Event::kReady, kNextIsPreparation, kSendPreparation,
        State::kWaitStop, "2016", "D3, D13"},
  Arrow{"prepare_late", State::kWaitStop, Event::kReadyTimeout, kNextIsPreparation, kSendPreparation,
        State::kWaitStop, "2016", "D3, D13"},
  Arrow{"start", State::kWaitStop, Event::kReady, kNextStartsPlay, kStartPlay,
        State::kRun, "paper 4.2, 4.4", "D13"},
  Arrow{"start_late", State::kWaitStop, Event::kReadyTimeout, kNextStartsPlay, kStartPlay,
        State::kRun, "paper 4.2, a fixed timeout", "D13"},
  Arrow{"goal", State::kRun, Event::kGoal, kAlways, kAwardGoal,
        State::kDelayWait, "paper 4.2, 4.3", ""},
  Arrow{"throw_in", State::kRun, Event::kThrowIn, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2", ""},
  Arrow{"corner_kick", State::kRun, Event::kCornerKick, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2", ""},
  Arrow{"goal_kick", State::kRun, Event::kGoalKick, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2", ""},
  Arrow{"touch_line_unknown", State::kRun, Event::kTouchLineUnknown, kAlways, kStopPlay,
        State::kWaitStop, "ours", "D14"},
  Arrow{"attacker_near_area", State::kRun, Event::kAttackerNearArea, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2; Laws", "D9"},
  Arrow{"restart_not_taken", State::kRun, Event::kRestartNotTaken, kAlways, kStopPlay,
        State::kWaitStop, "2016, Laws", "D10"},
  Arrow{"stuck_ball", State::kRun, Event::kStuckBall, kAlways, kStopPlay,
        State::kWaitStop, "2016, Laws", "D11"},
  Arrow{"signalled", State::kDelayWait, Event::kSignalled, kDuringGame, kStopAfterSignal,
        State::kWaitStop, "paper 4.3; STOP: 2016", "D4"},
};

constexpr std::array kOutsideFigure = {
  Arrow{"half_over", std::nullopt, Event::kHalfOver, kAlways, kEndHalf,
        State::kDelayWait, "paper 4.2, 4.3; HALT: ours", "D12"},
  Arrow{"next_half", State::kDelayWait, Event::kSignalled, kBetweenHalves, kBeginNextHalf,
        State::kWaitStop, "paper 4.2, 4.3; Laws", "D12"},
  Arrow{"game_over", std::nullopt, Event::kGameOver, kGameWasLast, kEndGame,
        State::kOver, "paper 4.2", ""},
  Arrow{"game_over_next", std::nullopt, Event::kGameOver, kNewGameFollows, kEndGame,
        State::kDelayWait, "paper 4.2; HALT: ours", "D12"},
  Arrow{"new_game", State::kDelayWait, Event::kSignalled, kAfterGame, kBeginNewGame,
        State::kWaitStop, "paper 4.2", ""},
};
constexpr std::array kBeyondPaper = {
  Arrow{"no_progress", State::kRun, Event::kNoProgress, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"kick_speed", State::kRun, Event::kKickSpeed, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"chip_goal", State::kRun, Event::kChipGoal, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"goal_invalid", State::kRun, Event::kGoalInvalid, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"indirect_goal", State::kRun, Event::kIndirectGoal, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"free_kick_own_goal", State::kRun, Event::kFreeKickOwnGoal, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"defender_in_area", State::kRun, Event::kDefenderInArea, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"defender_partly_in_area", State::kRun, Event::kDefenderPartlyInArea, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"attacker_in_area", State::kRun, Event::kAttackerInArea, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"double_touch", State::kRun, Event::kDoubleTouch, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"dribbling", State::kRun, Event::kDribbling, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"keeper_holding", State::kRun, Event::kKeeperHolding, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"pushing", State::kRun, Event::kPushing, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"kickoff_positions", State::kRun, Event::kKickoffPositions, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"penalty_positions", State::kRun, Event::kPenaltyPositions, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"penalty_failed", State::kRun, Event::kPenaltyFailed, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"aimless_kick", State::kRun, Event::kAimlessKick, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"offside", State::kRun, Event::kOffside, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"goal_line_unknown", State::kRun, Event::kGoalLineUnknown, kAlways, kStopPlay,
        State::kWaitStop, "ours", "D14"},
  Arrow{"restart_distance", State::kRun, Event::kRestartDistance, kFoulsStopPlay, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"restart_distance_noted", State::kRun, Event::kRestartDistance, kFoulsAreNoted, kNoteFoul,
        State::kRun, "rule book", ""},
  Arrow{"crash", State::kRun, Event::kCrash, kFoulsStopPlay, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"crash_noted", State::kRun, Event::kCrash, kFoulsAreNoted, kNoteFoul,
        State::kRun, "rule book", ""},
  Arrow{"crash_drawn", State::kRun, Event::kCrashDrawn, kAlways, kNoteFoul,
        State::kRun, "rule book", ""},
  Arrow{"attacker_stays_near_area", State::kRun, Event::kAttackerStaysNearArea, kAlways, kNoteFoul,
        State::kRun, "rule book", ""},
  Arrow{"attacker_stays_near_area_stopped", State::kWaitStop, Event::kAttackerStaysNearArea, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
  Arrow{"stop_speed", State::kWaitStop, Event::kStopSpeed, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
  Arrow{"stop_distance", State::kWaitStop, Event::kStopDistance, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
  Arrow{"placement_interference", State::kWaitStop, Event::kPlacementInterference, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
  Arrow{"too_many_robots", State::kRun, Event::kTooManyRobots, kAlways, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Arrow{"too_many_robots_stopped", State::kWaitStop, Event::kTooManyRobots, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
};
// clang-format on

bool leads_on(const Arrow& arrow, const Memory& memory, const Moment& moment, Event event) {
  return arrow.event == event && (!arrow.from || *arrow.from == memory.state) &&
         arrow.guard.holds(memory, moment.configuration);
}

void follow_play(Memory& memory, State before, double now_s) {
  if (before == memory.state) return;
  if (before == State::kRun) memory.play_clock.stop(now_s);
  if (memory.state == State::kRun) memory.play_clock.start(now_s);
}

const Arrow* find_arrow(const Memory& memory, const Moment& moment, Event event) {
  for (const std::span<const Arrow> arrows : all_arrows()) {
    for (const Arrow& arrow : arrows) {
      if (leads_on(arrow, memory, moment, event)) return &arrow;
    }
  }
  return nullptr;
}

}  // namespace

std::span<const Arrow> arrows_in_figure() { return kInFigure; }
std::span<const Arrow> arrows_outside_figure() { return kOutsideFigure; }
std::span<const Arrow> arrows_beyond_paper() { return kBeyondPaper; }

std::array<std::span<const Arrow>, 4> all_arrows() {
  return {arrows_of_administration(), arrows_in_figure(), arrows_outside_figure(),
          arrows_beyond_paper()};
}

Step step(const Memory& memory, const Moment& moment, const Finding& finding) {
  Step taken{memory, find_arrow(memory, moment, finding.event), std::nullopt};
  if (taken.arrow == nullptr) return taken;
  taken.arrow->action.take(taken.memory, moment, finding);
  taken.memory.state = taken.arrow->to;
  follow_play(taken.memory, memory.state, moment.time_s());
  if (taken.memory.signal.command_counter != memory.signal.command_counter) {
    taken.sent = taken.memory.signal.command;
  }
  return taken;
}

}  // namespace autoref::referee
