// Games under a rule book in which the test drives the robots, for tests of single rules.
#pragma once

#include <optional>
#include <vector>

#include "soccer/random.hpp"
#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {

inline constexpr RobotId kWest0{Side::kWest, 0};
inline constexpr RobotId kEast0{Side::kEast, 0};

// Moves robots at constant velocity and passes frames to the referee, with or without noise.
class DrivenGame {
 public:
  explicit DrivenGame(const Configuration& configuration) : game(in_play(configuration)) {}

  void put(RobotId id, const Vec2& position_m, const Vec2& velocity_mps,
           const Vec2& heading = {1, 0}) {
    RobotObservation& robot = game.robot(id.side, id.number);
    robot.position_m = position_m;
    robot.heading = heading;
    for (Driven& driven : driven_) {
      if (driven.id == id) driven = {id, position_m, velocity_mps};
      if (driven.id == id) return;
    }
    driven_.push_back({id, position_m, velocity_mps});
  }

  void drive(RobotId id, const Vec2& velocity_mps) {
    for (Driven& driven : driven_) {
      if (driven.id == id) driven.velocity_mps = velocity_mps;
    }
  }

  // Keeps the ball `gap_m` in front of that robot or, without a robot, in its place.
  void carry(std::optional<RobotId> id, double gap_m = 0) {
    carrier_ = id;
    gap_m_ = gap_m;
  }

  // Runs for `seconds`, with a normally distributed error on each coordinate.
  void run(double seconds, double noise_m = 0) {
    const int frames = static_cast<int>(seconds * ScriptedGame::kRate_hz + 0.5);
    for (int i = 0; i < frames; ++i) {
      for (Driven& driven : driven_) {
        driven.position_m += driven.velocity_mps / ScriptedGame::kRate_hz;
        RobotObservation& robot = game.robot(driven.id.side, driven.id.number);
        robot.position_m = driven.position_m + error_m(noise_m);
        if (driven.id != carrier_) continue;
        const double ahead_m = kFrontDistance_m + kBallRadius_m + gap_m_;
        game.put_ball(driven.position_m + ahead_m * robot.heading + error_m(noise_m));
      }
      game.step();
    }
  }

  // All decisions with that event.
  std::vector<Decision> calls(Event event) const {
    std::vector<Decision> found;
    for (const Decision& decision : game.decisions) {
      if (decision.finding.event == event) found.push_back(decision);
    }
    return found;
  }

  ScriptedGame game;

 private:
  struct Driven {
    RobotId id;
    Vec2 position_m{0, 0};
    Vec2 velocity_mps{0, 0};
  };

  Vec2 error_m(double noise_m) {
    const double along = random_.normal();
    const double across = random_.normal();
    return noise_m * Vec2(along, across);
  }

  std::vector<Driven> driven_;
  std::optional<RobotId> carrier_;
  double gap_m_ = 0;
  RandomStream random_{7};
};

}  // namespace autoref::referee
