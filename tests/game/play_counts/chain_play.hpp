// A scripted sequence of play with calls and restarts, whose possession chains are checked.
#pragma once

#include <optional>

#include "game/play_counts/possession_chains.hpp"
#include "tests/game/play_counts/play_sequence.hpp"

namespace autoref::game {

struct ChainPlay : PlaySequence {
  static referee::Decision decision_of(referee::Event event, std::optional<Command> command = {}) {
    referee::Decision decision;
    decision.finding.event = event;
    decision.command = command;
    return decision;
  }

  // A decision that stops play.
  static referee::Decision call(referee::Event event, std::optional<Side> offender = {}) {
    referee::Decision decision = decision_of(event, Command{CommandKind::kStop});
    decision.from = referee::State::kRun;
    decision.to = referee::State::kWaitStop;
    decision.finding.offender = offender;
    return decision;
  }

  // Two touches at the same place, which gain the ball.
  void gain(RobotId id, const Vec2& ball_m) {
    hull(id, ball_m);
    frames(10);
    hull(id, ball_m);
    frame();
  }
  void stop_by(const referee::Decision& decision) {
    decide(decision);
    stop();
  }
  void restart(Command command, RobotId kicker, const Vec2& ball_m) {
    decide(decision_of(referee::Event::kReady, command));
    signal_play();
    kick(kicker, ball_m, {-goal_sign(kicker.side) * 2, 0});
    frames(2);
  }
  // Plays the restart that follows a call, and returns how the next chain began.
  ChainStart start_after(referee::Event event, CommandKind kind) {
    gain(kWest1, {0, 0});
    referee::Decision decision = call(event, Side::kWest);
    decision.finding.restart = {kind, Side::kEast};
    stop_by(decision);
    restart({kind, Side::kEast}, kEast1, {0, 1});
    return last_start();
  }
  // Ends play and returns the start of the chain that was in progress.
  ChainStart last_start() {
    stop();
    return chains.back().start;
  }
};

}  // namespace autoref::game
