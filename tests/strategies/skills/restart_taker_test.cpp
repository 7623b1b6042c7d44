#include "strategies/skills/play_ball.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

// Robot 1 has taken a restart; the ball is in play.
struct TakenRestart {
  TakenRestart() {
    world.own(1, {0, 0}).own(2, {1, 0}).opponent(0, {3, 0}).ball({0.1, 0});
    taker.update(world.view, 1);
    world.view.play = Play::kRunning;
  }
  int number_with_ball_at(const Vec2& ball_m) {
    world.ball(ball_m);
    taker.update(world.view, -1);
    return taker.number();
  }

  StagedWorld world{Play::kDirectFree, true};
  RestartTaker taker;
};

TEST(RestartTaker, IsRememberedWhileNobodyElseHasTheBall) {
  TakenRestart restart;
  EXPECT_EQ(restart.number_with_ball_at({0.1, 0}), 1);
  EXPECT_EQ(restart.number_with_ball_at({0.5, 0}), 1);
}

TEST(RestartTaker, MayPlayOnOnceATeamMateOrAnOpponentHasTheBall) {
  EXPECT_EQ(TakenRestart().number_with_ball_at({0.9, 0}), -1);
  EXPECT_EQ(TakenRestart().number_with_ball_at({2.9, 0}), -1);
}

}  // namespace
}  // namespace autoref::strategies
