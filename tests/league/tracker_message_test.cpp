#include "league/tracker_message.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "league/log_contents.hpp"
#include "league/messages/vision.pb.h"
#include "tests/league/scratch_log.hpp"

namespace autoref::league {
namespace {

constexpr double kToday_s = 1.783e9;  // Unix time in 2026

TrackerPacket packet_at(double unix_s, const std::string& uuid = "a") {
  TrackerPacket packet;
  packet.set_uuid(uuid);
  packet.mutable_tracked_frame()->set_frame_number(1);
  packet.mutable_tracked_frame()->set_timestamp(unix_s);
  return packet;
}

void add_ball(TrackerPacket& packet, float x_m, float visibility) {
  TrackerBall& ball = *packet.mutable_tracked_frame()->add_balls();
  ball.mutable_pos()->set_x(x_m);
  ball.mutable_pos()->set_y(0);
  ball.mutable_pos()->set_z(0);
  ball.set_visibility(visibility);
}

void add_robot(TrackerPacket& packet, std::uint32_t id, int team, float x_m) {
  TrackerRobot& robot = *packet.mutable_tracked_frame()->add_robots();
  robot.mutable_robot_id()->set_id(id);
  robot.mutable_robot_id()->set_team(team);
  robot.mutable_pos()->set_x(x_m);
  robot.mutable_pos()->set_y(0);
  robot.set_orientation(0);
}

TEST(TrackFollower, ReadsTracksBack) {
  Tracks tracks;
  tracks.robots[Side::kWest].push_back({3, {1.5, -0.25}, {0, 1}, {0.5, 2}, -1.5, true});
  tracks.robots[Side::kEast].push_back({15, {-4, 2}, {1, 0}, {0, 0}, 0, false});
  tracks.ball = TrackedBall{{0.125, 4}, {-6.5, 1}, 0.5};
  TrackerPacket packet;
  fill_tracker(tracks, {"0c", "AutoRef"}, kToday_s, packet);
  TrackFollower follower;
  ASSERT_TRUE(follower.add(packet, 0));
  const TrackedRobot& yellow = follower.tracks().robots[Side::kWest].at(0);
  EXPECT_EQ(yellow.number, 3);
  EXPECT_EQ(yellow.position_m, Vec2(1.5, -0.25));
  EXPECT_EQ(yellow.velocity_mps, Vec2(0.5, 2));
  EXPECT_EQ(yellow.angular_velocity_radps, -1.5);
  EXPECT_NEAR(yellow.heading.y(), 1, 1e-6);
  EXPECT_FALSE(follower.tracks().robots[Side::kEast].at(0).is_seen);
  EXPECT_EQ(follower.tracks().ball->velocity_mps, Vec2(-6.5, 1));
  EXPECT_EQ(follower.tracks().ball->height_m, 0.5);
  EXPECT_EQ(follower.frame().robots[Side::kWest].size(), 1U);
  EXPECT_TRUE(follower.frame().robots[Side::kEast].empty());
  EXPECT_EQ(follower.frame().ball->height_m, 0.5);
}

// The numbers of TrackerWrapperPacket, in bytes written out by hand: uuid 1, tracked_frame 3 with
// frame_number 1, timestamp 2, and one robot 4 with robot_id 1 {id 1, team 2}, pos 2,
// orientation 3.
TEST(TrackFollower, ReadsTheLeaguesNumbers) {
  using namespace std::string_literals;
  const std::string one("\0\0\x80\x3F", 4);  // 1.0F
  const std::string half("\0\0\0\x3F", 4);   // 0.5F
  const std::string unix_s("\0\0\0\0\0\0\xF0\x3F", 8);
  const std::string robot =
      "\x0A\x04\x08\x07\x10\x02"s + "\x12\x0A\x0D"s + one + "\x15"s + half + "\x1D"s + half;
  const std::string frame =
      "\x08\x01\x11"s + unix_s + "\x22"s + static_cast<char>(robot.size()) + robot;
  const std::string bytes = "\x0A\x01x\x1A"s + static_cast<char>(frame.size()) + frame;
  TrackerPacket packet;
  ASSERT_TRUE(packet.ParseFromString(bytes));
  TrackFollower follower;
  ASSERT_TRUE(follower.add(packet, 0));
  const TrackedRobot& robot_read = follower.tracks().robots[Side::kEast].at(0);
  EXPECT_EQ(robot_read.number, 7);
  EXPECT_EQ(robot_read.position_m, Vec2(1, 0.5));
  EXPECT_NEAR(robot_read.heading.x(), std::cos(0.5), 1e-6);
}

TEST(TrackFollower, TakesTheMostVisibleBallThenTheNearest) {
  TrackFollower follower;
  TrackerPacket first = packet_at(kToday_s);
  add_ball(first, 1, 0.2F);
  add_ball(first, 2, 0.9F);
  follower.add(first, 0);
  EXPECT_EQ(follower.tracks().ball->position_m.x(), 2);
  TrackerPacket second = packet_at(kToday_s + 0.01);
  add_ball(second, -3, 1);
  add_ball(second, 2.5F, 1);
  follower.add(second, 0.01);
  EXPECT_EQ(follower.tracks().ball->position_m.x(), 2.5);
}

TEST(TrackFollower, IgnoresObjectsThatCannotBe) {
  TrackerPacket packet = packet_at(kToday_s);
  add_robot(packet, 16, 1, 0);
  add_robot(packet, 4, 0, 0);
  add_robot(packet, 5, 1, std::nanf(""));
  add_robot(packet, 6, 2, 1);
  packet.mutable_tracked_frame()->mutable_robots(3)->mutable_vel()->set_x(INFINITY);
  packet.mutable_tracked_frame()->mutable_robots(3)->mutable_vel()->set_y(0);
  add_ball(packet, 1e9F, 1);
  TrackFollower follower;
  ASSERT_TRUE(follower.add(packet, 0));
  EXPECT_TRUE(follower.tracks().robots[Side::kWest].empty());
  ASSERT_EQ(follower.tracks().robots[Side::kEast].size(), 1U);
  EXPECT_EQ(follower.tracks().robots[Side::kEast][0].velocity_mps, Vec2(0, 0));
  EXPECT_FALSE(follower.tracks().ball);
}

TEST(TrackFollower, FollowsTheFirstSourceUntilItIsSilent) {
  TrackFollower follower;
  EXPECT_TRUE(follower.add(packet_at(kToday_s, "a"), 0));
  EXPECT_FALSE(follower.add(packet_at(50, "b"), 0.5));
  EXPECT_TRUE(follower.add(packet_at(kToday_s + 0.6, "a"), 0.6));
  EXPECT_FALSE(follower.add(packet_at(51, "b"), 1.5));
  EXPECT_TRUE(follower.add(packet_at(51.2, "b"), 1.7));
  EXPECT_NEAR(follower.frame().time_s, 1.7, 1e-6);
  EXPECT_FALSE(follower.add(packet_at(kToday_s + 2, "a"), 2));
  EXPECT_TRUE(follower.add(packet_at(51.3, "b"), 1.8));
  EXPECT_NEAR(follower.frame().time_s, 1.8, 1e-6);
  EXPECT_EQ(follower.source().sources(), 2);
}

TEST(TrackFollower, ContinuesItsTimesWhenTheClockLeaps) {
  TrackFollower follower;
  follower.add(packet_at(kToday_s), 0);
  EXPECT_FALSE(follower.add(packet_at(kToday_s - 0.1), 0.02));  // late
  EXPECT_FALSE(follower.add(packet_at(std::nan("")), 0.03));
  EXPECT_EQ(follower.unusable(), 1);
  EXPECT_TRUE(follower.add(packet_at(7), 0.04));
  EXPECT_NEAR(follower.frame().time_s, 0.04, 1e-6);
  EXPECT_TRUE(follower.add(packet_at(7.02), 0.06));
  EXPECT_NEAR(follower.frame().time_s, 0.06, 1e-6);
}

class Shown final : public LogVisitor {
 public:
  void on_frame(const Frame& frame) override { ball_x_m.push_back(frame.ball->position_m.x()); }
  void on_tracks(const Frame& /*frame*/, const Tracks& /*tracks*/) override { ++tracks; }
  std::vector<double> ball_x_m;
  int tracks = 0;
};

TEST(ReadLog, ShowsTheTrackersFramesWithoutVision) {
  const ScratchFile file(".log");
  LogWriter writer(file.path());
  for (int i = 0; i < 3; ++i) {
    TrackerPacket packet = packet_at(kToday_s + 0.01 * i);
    add_ball(packet, static_cast<float>(i), 1);
    writer.write(10'000'000 * i, MessageKind::kTracker2020, packet.SerializeAsString());
  }
  writer.close();
  Shown shown;
  const LogSummary log = read_log(file.path(), shown);
  EXPECT_EQ(shown.ball_x_m, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(log.frames, 3);
  EXPECT_TRUE(log.frames_are_tracked);
  EXPECT_EQ(log.trackers, 1);
  EXPECT_EQ(log.faults.unreadable, 0);
}

TEST(ReadLog, PrefersVisionToATrackerUnlessOneIsChosen) {
  const ScratchFile file(".log");
  LogWriter writer(file.path());
  TrackerPacket tracker = packet_at(kToday_s);
  add_ball(tracker, 1, 1);
  writer.write(0, MessageKind::kTracker2020, tracker.SerializeAsString());
  VisionPacket vision;
  DetectionFrame& detection = *vision.mutable_detection();
  detection.set_frame_number(1);
  detection.set_t_capture(kToday_s);
  detection.set_t_sent(kToday_s);
  detection.set_camera_id(0);
  DetectionBall& ball = *detection.add_balls();
  ball.set_x(-2000);
  for (auto set : {&DetectionBall::set_y, &DetectionBall::set_confidence,
                   &DetectionBall::set_pixel_x, &DetectionBall::set_pixel_y})
    (ball.*set)(0);
  writer.write(1, MessageKind::kVision2014, vision.SerializeAsString());
  writer.close();
  Shown shown;
  EXPECT_EQ(read_log(file.path(), shown).frames, 1);
  EXPECT_EQ(shown.ball_x_m, std::vector<double>{-2});
  EXPECT_EQ(shown.tracks, 1);
  Shown tracked;
  EXPECT_TRUE(read_log(file.path(), tracked, FrameSource::kTracker).frames_are_tracked);
  EXPECT_EQ(tracked.ball_x_m, std::vector<double>{1});
}

}  // namespace
}  // namespace autoref::league
