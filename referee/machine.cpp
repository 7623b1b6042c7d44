#include "referee/machine.hpp"

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
// clang-format on

bool leads_on(const Arrow& arrow, const Memory& memory, const Moment& moment, Event event) {
  return arrow.event == event && (!arrow.from || *arrow.from == memory.state) &&
         arrow.guard.holds(memory, moment.configuration);
}

const Arrow* find_arrow(const Memory& memory, const Moment& moment, Event event) {
  for (const std::span<const Arrow> arrows : {arrows_in_figure(), arrows_outside_figure()}) {
    for (const Arrow& arrow : arrows) {
      if (leads_on(arrow, memory, moment, event)) return &arrow;
    }
  }
  return nullptr;
}

}  // namespace

std::span<const Arrow> arrows_in_figure() { return kInFigure; }
std::span<const Arrow> arrows_outside_figure() { return kOutsideFigure; }

Step step(const Memory& memory, const Moment& moment, const Finding& finding) {
  Step taken{memory, find_arrow(memory, moment, finding.event), std::nullopt};
  if (taken.arrow == nullptr) return taken;
  taken.arrow->action.take(taken.memory, moment, finding);
  taken.memory.state = taken.arrow->to;
  if (taken.memory.signal.command_counter != memory.signal.command_counter) {
    taken.sent = taken.memory.signal.command;
  }
  return taken;
}

}  // namespace autoref::referee
