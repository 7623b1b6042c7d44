// A penalty kick without physics, from its award to its outcome. Calls the machine, its rules and
// its readiness checks frame by frame, as the referee does, on a state in which a penalty kick has
// just been awarded.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/machine.hpp"
#include "referee/machine/readiness.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/online_touch_detector.hpp"
#include "soccer/robot_shape.hpp"
#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {

// Positions are given for a kick by west towards the east; if east kicks, they are rotated.
class PenaltyGame {
 public:
  PenaltyGame(std::string_view book, Side kicker)
      : configuration_(by_book(book)),
        kicker_(kicker),
        touch_(frames_, configuration_.field, configuration_.touch),
        mark_m(configuration_.field.half_length_m() - configuration_.field.penalty_mark_m, 0) {
    frame_.ball = BallObservation{at(mark_m), 0.0};
    for (int i = 0; i < 4; ++i) {
      add(kicker, i, {mark_m.x() - 1.2, -0.9 + 0.4 * i});
      add(opponent_of(kicker), i, {mark_m.x() - 1.5, -0.9 + 0.4 * i});
    }
    put(opponent_of(kicker), 0, {configuration_.field.half_length_m() - 0.05, -0.2});
    award();
  }

  // Runs until NORMAL_START, with the kicker behind the ball.
  PenaltyGame& whistle() {
    run_until("prepare");
    put(kicker_, 1, mark_m - Vec2(kFrontDistance_m + kBallRadius_m + 0.001, 0));
    run_until("start");
    return *this;
  }

  // The referee never sees the ball.
  void hide_ball() {
    is_ball_hidden_ = true;
    ball_.reset();
  }

  void put(Side side, int number, const Vec2& position_m) {
    for (RobotObservation& robot : frame_.robots[side]) {
      if (robot.number == number) robot.position_m = at(position_m);
    }
  }

  void kick(const Vec2& velocity_mps) {
    run(0.2);
    ball_mps_ = at(velocity_mps);
  }

  // Sets the ball's new velocity once it is within `gap_m` of the keeper's hull.
  void save(const Vec2& velocity_mps) {
    const RobotObservation& keeper = frame_.robots[opponent_of(kicker_)].front();
    for (int i = 0; i < 60; ++i) {
      if (gap_to_robot_m(keeper, frame_.ball->position_m) < 0.01) break;
      step();
    }
    ball_mps_ = at(velocity_mps);
  }

  void step() {
    frame_.number = ++number_;
    frame_.time_s = static_cast<double>(number_) / 60;
    see();
    if (state.machine_state == State::kRun) {
      frames_.push(frame_);
      touch_.update();
    }
    const RefereeInput now = input();
    if (state.machine_state == State::kRun) watch_play(state.play, now);
    if (!ask_rules(now) && state.machine_state == State::kWaitStop) {
      if (const auto found = find_ready(state, now)) decide(now, *found);
    }
    frame_.ball->position_m += ball_mps_ / 60;
    if (!state.signal.placement) return;
    frame_.ball->position_m = state.signal.placement->target_m;
    ball_mps_ = Vec2(0, 0);
  }

  void run(double seconds) {
    for (int i = 0; i < seconds * 60; ++i) step();
  }

  Finding run_until(std::string_view transition, double limit_s = 12) {
    for (int i = 0; i < limit_s * 60; ++i) {
      step();
      if (!transitions.empty() && transitions.back() == transition) return last;
    }
    throw std::runtime_error("transition never used: " + std::string(transition));
  }

  int count(std::string_view transition) const {
    int found = 0;
    for (const std::string& taken : transitions) found += taken == transition ? 1 : 0;
    return found;
  }

  double now_s() const { return frame_.time_s; }
  // Rotates a position to the end that the kicking side attacks.
  Vec2 at(const Vec2& v) const { return kicker_ == Side::kWest ? v : Vec2(-v); }
  const Field& field() const { return configuration_.field; }

  RefereeState state;
  std::vector<std::string> transitions;
  Finding last;

 private:
  void add(Side side, int number, const Vec2& position_m) {
    frame_.robots[side].push_back({number, at(position_m), at(Vec2(side == kicker_ ? 1 : -1, 0))});
  }

  RefereeInput input() const {
    return {configuration_, frame_, ball_, touch_.last(), tracks_, requests_, frames_};
  }

  void award() {
    see();
    state.machine_state = State::kRun;
    state.signal.stage = Stage::kFirstHalf;
    Finding foul;
    foul.event = Event::kDefenderInDefenseArea;
    foul.restart = {CommandKind::kPreparePenalty, kicker_};
    foul.ball_to_m = field().penalty_mark_at(opponent_of(kicker_));
    decide(input(), foul);
  }

  void see() {
    if (is_ball_hidden_) return;
    const Vec2 now_m = frame_.ball->position_m;
    ball_ = BallSight{now_m, ball_ ? ball_->position_m : now_m};
  }

  // Returns whether a rule changed the state.
  bool ask_rules(const RefereeInput& now) {
    const State machine_state = state.machine_state;
    for (const ListedRule& listed : rules()) {
      if (configuration_.rules.has(listed.id)) evaluate(*listed.rule, now, machine_state);
      if (state.machine_state != machine_state) return true;
    }
    return false;
  }

  void evaluate(const Rule& rule, const RefereeInput& now, State machine_state) {
    for (const RuleSearch& search : rule.searches()) {
      if (state.machine_state != machine_state || !search.active_in.has(machine_state)) continue;
      if (const auto found = search.find(state, now)) decide(now, *found);
    }
  }

  void decide(const RefereeInput& now, const Finding& finding) {
    Step taken = referee::step(state, now, finding);
    if (taken.transition == nullptr) throw std::runtime_error("no transition applies");
    const bool starts =
        state.machine_state != State::kRun && taken.state.machine_state == State::kRun;
    state = taken.state;
    transitions.emplace_back(taken.label);
    last = finding;
    if (!starts) return;
    frames_.restart(frame_, state.play.ball_from_m);
    touch_.restart();
  }

  Configuration configuration_;
  Side kicker_;
  FrameHistory frames_;
  OnlineTouchDetector touch_;
  Frame frame_;
  Tracks tracks_;
  PerSide<TeamRequests> requests_;  // both keepers are number 0
  std::optional<BallSight> ball_;
  Vec2 ball_mps_{0, 0};
  bool is_ball_hidden_ = false;
  std::int64_t number_ = 0;

 public:
  const Vec2 mark_m;
};

}  // namespace autoref::referee
