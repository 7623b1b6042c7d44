#include "logs/fit/recorded_motion.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/logs/sketched_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::logs {
namespace {

std::vector<RecordedMotion> motions_of(const SketchedLog& sketch) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "game.log";
  write_sketch(sketch, path);
  std::vector<RecordedMotion> motions;
  for_each_motion(path, [&](const RecordedMotion& motion) { motions.push_back(motion); });
  return motions;
}

TEST(RecordedMotion, HoldsBallAndRobotsOfEachFrame) {
  const std::vector<RecordedMotion> motions = motions_of({});
  ASSERT_EQ(motions.size(), 1U);
  const RecordedMotion& motion = motions.front();
  EXPECT_NEAR(motion.times_s.back() - motion.times_s.front(), 6, 0.1);
  EXPECT_NEAR(motion.interval_s, 1.0 / 60, 1e-3);
  EXPECT_EQ(motion.robots.size(), 12U);
  ASSERT_EQ(motion.ball.size(), motion.frames());
  ASSERT_EQ(motion.robots[0].sights.size(), motion.frames());
  EXPECT_EQ(motion.captures_s.size(), 4U);
  EXPECT_TRUE(motion.ball[10].is_seen);
  EXPECT_EQ(motion.cameras.size(), 4U);
}

TEST(RecordedMotion, PlayRunsFromTheRefereesCommandOn) {
  const RecordedMotion motion = motions_of({}).front();
  EXPECT_FALSE(motion.is_running[motion.frame_at(0.7)]);
  EXPECT_TRUE(motion.is_running.back());
  SketchedLog alone;
  alone.has_referee = false;
  EXPECT_TRUE(motions_of(alone).front().is_running[0]);
}

TEST(RecordedMotion, InterpolatesWhereVisionMissedSomething) {
  SketchedLog sketch;
  sketch.change_detection = [](league::DetectionFrame& detection) {
    const bool is_missed = detection.frame_number() % 10 == 5;
    if (!is_missed) return;
    detection.clear_balls();
    detection.clear_robots_yellow();
  };
  const RecordedMotion whole = motions_of({}).front();
  const RecordedMotion motion = motions_of(sketch).front();
  ASSERT_EQ(motion.frames(), whole.frames());
  int missed = 0;
  for (std::size_t i = 20; i + 20 < motion.frames(); ++i) {
    if (motion.ball[i].is_seen) continue;
    ++missed;
    EXPECT_LT((motion.ball[i].position_m - whole.ball[i].position_m).norm(), 0.01);
    EXPECT_FALSE(motion.robots[0].sights[i].is_seen);
    EXPECT_TRUE(motion.robots[0].sights[i].is_known);
    EXPECT_LT((motion.robots[0].sights[i].position_m - whole.robots[0].sights[i].position_m).norm(),
              0.01);
  }
  EXPECT_GT(missed, 20);
}

TEST(RecordedMotion, NeedsVision) {
  SketchedLog sketch;
  sketch.has_vision = false;
  EXPECT_TRUE(motions_of(sketch).empty());
}

TEST(RecordedMotion, AFalseBallIsAnotherBall) {
  SketchedLog sketch;
  sketch.change_detection = [](league::DetectionFrame& detection) {
    if (detection.frame_number() % 50 != 25 || detection.balls().empty()) return;
    league::DetectionBall& ball = *detection.add_balls();
    ball = detection.balls(0);
    ball.set_x(detection.balls(0).x() > 0 ? -2000 : 2000);
  };
  const RecordedMotion motion = motions_of(sketch).front();
  EXPECT_GE(motion.other_balls.size(), 5U);
  for (const OtherBall& other : motion.other_balls)
    EXPECT_GT((other.position_m - motion.ball[other.frame].position_m).norm(), 1);
}

TEST(RecordedMotion, DropsASingleJumpOfTheBall) {
  const RecordedMotion whole = motions_of({}).front();
  SketchedLog sketch;
  sketch.change_detection = [](league::DetectionFrame& detection) {
    if (detection.frame_number() != 120) return;
    for (auto& ball : *detection.mutable_balls()) ball.set_x(ball.x() + 150);
  };
  const RecordedMotion motion = motions_of(sketch).front();
  ASSERT_EQ(motion.spikes.size(), 1U);
  const std::size_t frame = motion.spikes.front();
  EXPECT_FALSE(motion.ball[frame].is_seen);
  EXPECT_LT((motion.ball[frame].position_m - whole.ball[frame].position_m).norm(), 0.01);
}

}  // namespace
}  // namespace autoref::logs
