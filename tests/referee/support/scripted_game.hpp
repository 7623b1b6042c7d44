// A game without physics: frames are written by hand, and the referee judges them at 60 Hz.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "referee/referee.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {

class ScriptedGame {
 public:
  static constexpr double kRate_hz = 60;

  explicit ScriptedGame(const Configuration& configuration = {}) : referee(configuration) {
    frame.ball = BallObservation{Vec2(0, 0), 0.0};
  }

  // Puts robots 0 to `count` - 1 of each side in columns near their own goal line, away from the
  // centre.
  ScriptedGame& line_up(int count = 6) {
    for (Side side : kSides) {
      for (int i = 0; i < count; ++i) {
        const Vec2 position(goal_sign(side) * (2.0 - 0.25 * (i % 2)), -1.6 + 0.5 * i);
        frame.robots[side].push_back({i, position, Vec2(-goal_sign(side), 0)});
      }
    }
    return *this;
  }

  RobotObservation& robot(Side side, int number) {
    for (RobotObservation& robot : frame.robots[side]) {
      if (robot.number == number) return robot;
    }
    throw std::out_of_range("no such robot");
  }

  void put_ball(const Vec2& ball_m) {
    frame.ball->position_m = ball_m;
    ball_mps = Vec2(0, 0);
  }

  // Plays one frame: the referee judges it, then the ball rolls on, or ball placement puts it in
  // position.
  const RefereeSignal& step() {
    frame.number = next_number_++;
    frame.time_s = static_cast<double>(frame.number) / kRate_hz;
    signal = referee.update(frame, requests);
    decisions.insert(decisions.end(), referee.decisions().begin(), referee.decisions().end());
    if (frame.ball) {
      frame.ball->position_m += ball_mps / kRate_hz;
      ball_mps = clamp_norm(ball_mps, std::max(0.0, ball_mps.norm() - carpet_mps2 / kRate_hz));
      if (signal.placement && placement_works) put_ball(signal.placement->target_m);
    }
    return signal;
  }

  void run(double seconds) {
    const int frames = static_cast<int>(seconds * kRate_hz + 0.5);
    for (int i = 0; i < frames; ++i) step();
  }

  // Lets this time pass without any frame from vision.
  void skip(double seconds) { next_number_ += static_cast<int>(seconds * kRate_hz + 0.5); }

  // Runs until a transition with that label; throws if there is none within `limit_s`.
  Decision run_until(std::string_view transition, double limit_s = 40) {
    for (int i = 0; i < limit_s * kRate_hz; ++i) {
      const std::size_t former = decisions.size();
      step();
      for (std::size_t k = former; k < decisions.size(); ++k) {
        if (decisions[k].transition == transition) return decisions[k];
      }
    }
    throw std::runtime_error("transition never used: " + std::string(transition));
  }

  // Plays from the first frame to the kick-off: every robot moves a little, then all stand still.
  ScriptedGame& kick_off() {
    step();
    for (Side side : kSides) {
      for (RobotObservation& robot : frame.robots[side]) robot.position_m.y() += 0.05;
    }
    run_until("start");
    return *this;
  }

  // The robot appears behind the ball, with its plate one millimetre away, and kicks the ball.
  void kick(Side side, int number, const Vec2& velocity_mps) {
    const Vec2 direction = velocity_mps.normalized();
    RobotObservation& kicker = robot(side, number);
    kicker.heading = direction;
    kicker.position_m =
        frame.ball->position_m - direction * (kFrontDistance_m + kBallRadius_m + 0.001);
    run(0.1);
    ball_mps = velocity_mps;
  }

  // Kicks the ball from `from_m` once it is in play.
  void kick_from(Side side, int number, const Vec2& from_m, const Vec2& velocity_mps) {
    put_ball(from_m);
    run(0.1);
    kick(side, number, velocity_mps);
  }

  int count(std::string_view transition) const {
    int found = 0;
    for (const Decision& decision : decisions) found += decision.transition == transition ? 1 : 0;
    return found;
  }

  double now_s() const { return frame.time_s; }

  Frame frame;
  PerSide<TeamRequests> requests;
  Vec2 ball_mps{0, 0};
  double carpet_mps2 = 0;  // deceleration of the ball
  bool placement_works = true;
  AutoRef referee;
  RefereeSignal signal;
  std::vector<Decision> decisions;

 private:
  std::int64_t next_number_ = 0;
};

// A game after its kick-off, with the ball in play near the centre.
inline ScriptedGame in_play(const Configuration& configuration = {}) {
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  game.put_ball({0.4, 0.2});
  game.run(0.1);
  return game;
}

}  // namespace autoref::referee
