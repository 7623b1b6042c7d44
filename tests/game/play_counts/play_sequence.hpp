// A scripted sequence of play: robots' positions, touches of the ball, stops and goals.
#pragma once

#include <algorithm>
#include <vector>

#include "game/play_counts/play_statistics.hpp"

namespace autoref::game {

inline constexpr RobotId kWest1{Side::kWest, 1};
inline constexpr RobotId kWest2{Side::kWest, 2};
inline constexpr RobotId kEast1{Side::kEast, 1};
inline constexpr RobotId kEast2{Side::kEast, 2};

// On the paper's field: goals at x = +-3.025 m, posts at y = +-0.35 m, touch lines at
// y = +-2.025 m. Robots face the opponents' goal.
class PlaySequence {
 public:
  PlaySequence() { signal_play(); }

  void put(RobotId id, const Vec2& position_m, const Vec2& velocity_mps = {0, 0}) {
    auto& robots = now.robots[id.side];
    robots.erase(std::remove_if(robots.begin(), robots.end(),
                                [=](const auto& robot) { return robot.number == id.number; }),
                 robots.end());
    robots.push_back({id.number, position_m, {-goal_sign(id.side), 0}, velocity_mps, 0});
  }

  // Adds touches to the next frame, in the order of the calls.
  void kick(RobotId id, const Vec2& ball_m, const Vec2& ball_mps, double vertical_mps = 0) {
    add({now.frame + 1, substep, id, ball_m, true, ball_mps, vertical_mps});
  }
  void hull(RobotId id, const Vec2& ball_m) {
    add({now.frame + 1, substep, id, ball_m, false, {0, 0}, 0});
  }
  void decide(const referee::Decision& decision) { decisions_.push_back(decision); }

  void frame() {
    ++now.frame;
    statistics.update({now, touches_, decisions_, is_on, is_in_play});
    const auto ended = statistics.ended_chains();
    chains.insert(chains.end(), ended.begin(), ended.end());
    const auto ended_shots = statistics.ended_shots();
    shots.insert(shots.end(), ended_shots.begin(), ended_shots.end());
    const auto ended_actions = statistics.ended_actions();
    actions.insert(actions.end(), ended_actions.begin(), ended_actions.end());
    touches_.clear();
    decisions_.clear();
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }

  // Adds a kick now and, a second later, a touch by `next` at `to_m`.
  void kick_to(RobotId kicker, const Vec2& from_m, const Vec2& ball_mps, RobotId next,
               const Vec2& to_m) {
    kick(kicker, from_m, ball_mps);
    frames(60);
    hull(next, to_m);
    frame();
  }

  void signal_play() {
    is_on = is_in_play = true;
    frame();
  }
  void stop() {
    is_on = is_in_play = false;
    frame();
  }
  void goal_of(Side side) {
    referee::Decision goal;
    goal.finding.event = referee::Event::kGoal;
    goal.command = Command{CommandKind::kGoal, side};
    goal.finding.restart = {CommandKind::kPrepareKickoff, opponent_of(side)};
    decide(goal);
    stop();
  }

  PlayCounts west() const { return statistics.counts()[Side::kWest]; }
  PlayCounts east() const { return statistics.counts()[Side::kEast]; }

  sim::WorldState now;
  std::vector<PossessionChain> chains;  // all that have ended
  std::vector<Shot> shots;              // of these chains
  std::vector<BallAction> actions;      // all that have ended
  PlayStatistics statistics{Field{}, sim::BallParameters{}, 60.0, chance_model("paper"),
                            value_model("paper")};
  bool is_on = false;
  bool is_in_play = false;
  int substep = 0;  // the sub-step of touches added from now on

 private:
  void add(const sim::Touch& touch) {
    now.ball.position_m = touch.ball_m;
    touches_.push_back(touch);
  }

  std::vector<sim::Touch> touches_;
  std::vector<referee::Decision> decisions_;
};

}  // namespace autoref::game
