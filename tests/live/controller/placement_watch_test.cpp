#include "live/controller/placement_watch.hpp"

#include <gtest/gtest.h>

namespace autoref::live {
namespace {

RefereeSignal placement_by_east(std::uint32_t counter = 7) {
  RefereeSignal signal;
  signal.command = {CommandKind::kBallPlacement, Side::kEast};
  signal.command_counter = counter;
  signal.placement = Placement{{1, 2}};
  return signal;
}

Tracks ball_at(const Vec2& position_m, double time_s) {
  Tracks tracks;
  tracks.time_s = time_s;
  tracks.ball = TrackedBall{};
  tracks.ball->position_m = position_m;
  return tracks;
}

TEST(PlacementWatch, ReportsABallThatHasBeenInPositionForHalfASecond) {
  PlacementWatch watch;
  EXPECT_FALSE(watch.update(placement_by_east(), ball_at({3, 2}, 10)));
  EXPECT_FALSE(watch.update(placement_by_east(), ball_at({1.1, 2}, 14)));
  EXPECT_FALSE(watch.update(placement_by_east(), ball_at({1.1, 2}, 14.4)));
  const std::optional<GameEvent> event = watch.update(placement_by_east(), ball_at({1.1, 2}, 14.6));
  ASSERT_TRUE(event);
  EXPECT_EQ(event->type, GameEventType::kPlacementSucceeded);
  EXPECT_EQ(event->by_team, Side::kEast);
  EXPECT_NEAR(*event->time_taken_s, 4.6, 1e-9);
  EXPECT_NEAR(*event->precision_m, 0.1, 1e-9);
  EXPECT_NEAR(*event->distance_m, 2, 1e-9);
}

TEST(PlacementWatch, ReportsEachPlacementOnce) {
  PlacementWatch watch;
  watch.update(placement_by_east(), ball_at({1, 2}, 1));
  EXPECT_TRUE(watch.update(placement_by_east(), ball_at({1, 2}, 2)));
  EXPECT_FALSE(watch.update(placement_by_east(), ball_at({1, 2}, 3)));
  EXPECT_FALSE(watch.update(placement_by_east(8), ball_at({1, 2}, 4)));
  EXPECT_TRUE(watch.update(placement_by_east(8), ball_at({1, 2}, 5)));
}

TEST(PlacementWatch, DoesNotReportABallThatIsFartherThan15CentimetresAway) {
  PlacementWatch watch;
  watch.update(placement_by_east(), ball_at({1.16, 2}, 1));
  EXPECT_FALSE(watch.update(placement_by_east(), ball_at({1.16, 2}, 5)));
}

TEST(PlacementWatch, WaitsUntilThePlacingRobotHasLeft) {
  PlacementWatch watch;
  Tracks tracks = ball_at({1, 2}, 1);
  tracks.robots[Side::kEast].push_back(TrackedRobot{3, {1.13, 2}});
  watch.update(placement_by_east(), tracks);
  tracks.time_s = 5;
  EXPECT_FALSE(watch.update(placement_by_east(), tracks));
}

TEST(PlacementWatch, WaitsUntilTheBallIsAtRest) {
  PlacementWatch watch;
  Tracks tracks = ball_at({1, 2}, 1);
  tracks.ball->velocity_mps = {0.5, 0};
  watch.update(placement_by_east(), tracks);
  tracks.time_s = 5;
  EXPECT_FALSE(watch.update(placement_by_east(), tracks));
}

}  // namespace
}  // namespace autoref::live
