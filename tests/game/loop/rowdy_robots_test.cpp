// The fouls of `rowdy` against opponents really happen in the simulated world.
#include <gtest/gtest.h>

#include "tests/game/loop/foul_behaviour.hpp"

namespace autoref::game {
namespace {

// Closing speed in the frame before the two hulls touch; 0 if they never touch.
double met_at_mps(StagedGame& game, RobotId one, RobotId other) {
  double before_mps = 0;
  const bool met = game.happens(5, [&] {
    const Vec2 apart_m = game.robot(other).position_m - game.robot(one).position_m;
    if (apart_m.norm() < 2 * kRobotRadius_m + 5_mm) return true;
    before_mps =
        (game.robot(one).velocity_mps - game.robot(other).velocity_mps).dot(apart_m.normalized());
    return false;
  });
  return met ? before_mps : 0;
}

TEST(Rowdy, RunsIntoAnOpponentAtSpeed) {
  FoulBehaviour game("ram");
  game.put_ball({2, 1.5});
  game.put_robot(kOpponent, {-0.1, -1.0});  // 0.9 m in front of kSecond
  game.start();
  EXPECT_GT(met_at_mps(game, kSecond, kOpponent), 1.6);
}

// An opponent that drives at 1.5 m/s towards the other side's last robot.
struct Chaser final : strategies::Strategy {
  void decide(const TeamView& view, TeamCommands& commands) override {
    if (view.own.empty() || view.opponents.empty()) return;
    const Vec2 path_m = view.opponents.back().position_m - view.own[0].position_m;
    commands[0].velocity_mps = to_local(1.5 * path_m.normalized(), view.own[0].heading);
  }
};

TEST(Rowdy, CrashesHeadOnIntoAnOpponentAtEqualSpeeds) {
  FoulBehaviour game("ram_evenly");
  game.teams[Side::kEast] = std::make_unique<Chaser>();
  game.put_ball({2, 1.5});
  game.put_robot(kOpponent, {0.9, -1.0}, {-1, 0});
  game.start();
  double rammer_mps = 0;
  double opponent_mps = 0;
  ASSERT_TRUE(game.happens(4, [&] {
    const Vec2 apart_m = game.robot(kOpponent).position_m - game.robot(kSecond).position_m;
    if (apart_m.norm() < 2 * kRobotRadius_m + 5_mm) return true;
    rammer_mps = game.robot(kSecond).velocity_mps.dot(apart_m.normalized());
    opponent_mps = -game.robot(kOpponent).velocity_mps.dot(apart_m.normalized());
    return false;
  }));
  EXPECT_GT(rammer_mps + opponent_mps, 1.5);
  EXPECT_NEAR(rammer_mps, opponent_mps, 0.3);
}

TEST(Rowdy, PushesAnOpponentBack) {
  FoulBehaviour game("shove");
  game.put_ball({2, 1.5});
  const Vec2 from_m(-0.4, -1.0);
  game.put_robot(kOpponent, from_m);
  game.start();
  game.run(4);
  EXPECT_GT((game.robot(kOpponent).position_m - from_m).norm(), 0.2);
}

}  // namespace
}  // namespace autoref::game
