#include "app/game/page_recorder.hpp"

#include <gtest/gtest.h>

namespace autoref::app {
namespace {

constexpr double kRate_hz = 60;

TEST(PageRecorder, RecordsChainsInSecondsAndWithNames) {
  game::PossessionChain chain;
  chain.team = Side::kEast;
  chain.start = game::ChainStart::kThrowIn;
  chain.end = game::ChainEnd::kLost;
  chain.first_frame = 90;
  chain.last_frame = 120;
  chain.passes = 3;
  chain.shots = 1;
  chain.xg = 0.25;
  const view::RecordedChain shown = recorded(chain, kRate_hz);
  EXPECT_EQ(shown.start_s, 1.5);
  EXPECT_EQ(shown.end_s, 2);
  EXPECT_EQ(shown.team, Side::kEast);
  EXPECT_EQ(shown.start, "throw_in");
  EXPECT_EQ(shown.end, "lost");
  EXPECT_EQ(shown.passes, 3);
  EXPECT_EQ(shown.shots, 1);
  EXPECT_EQ(shown.xg, 0.25);
}

TEST(PageRecorder, PublishesThePositionOfAShot) {
  game::Shot shot;
  shot.frame = 30;
  shot.from_m = {1, -2};
  shot.chance = 0.5;
  shot.has_scored = true;
  EXPECT_EQ(recorded(shot, kRate_hz, true).from_m, Vec2(1, -2));
  const view::RecordedShot turned = recorded(shot, kRate_hz, false);
  EXPECT_EQ(turned.from_m, Vec2(-1, 2));
  EXPECT_EQ(turned.time_s, 0.5);
  EXPECT_EQ(turned.xg, 0.5);
  EXPECT_TRUE(turned.has_scored);
}

}  // namespace
}  // namespace autoref::app
