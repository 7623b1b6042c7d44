#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "league/detection_merger.hpp"
#include "league/field_message.hpp"
#include "league/referee_message.hpp"
#include "league/vision_message.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::league {
namespace {

const std::vector<CameraPosition> kCameras = {{{-1.5, -1}}, {{-1.5, 1}}, {{1.5, -1}}, {{1.5, 1}}};

// Returns a position in eighths of a millimetre, which packets represent exactly.
Vec2 eighths(int x, int y) { return {x / 8.0 / 1000.0, y / 8.0 / 1000.0}; }

Frame busy_frame(std::int64_t number = 0) {
  Frame frame;
  frame.number = number;
  frame.time_s = static_cast<double>(number) / 60;
  for (int i = 0; i < 6; ++i) {
    const double angle_rad = static_cast<double>(static_cast<float>(0.9 * i - 2));
    frame.robots[Side::kWest].push_back(
        {i, eighths(-2401 - 3203 * i, 4001 * i - 10407), heading_of(angle_rad)});
    frame.robots[Side::kEast].push_back(
        {i, eighths(1603 + 2961 * i, 13601 - 4083 * i), heading_of(-angle_rad)});
  }
  frame.ball = BallObservation{eighths(987, -5235), 0.3, {}};
  return frame;
}

// Sends the frames camera by camera and returns the frames that are read back.
std::vector<Frame> sent_and_read(const std::vector<Frame>& frames) {
  std::vector<VisionPacket> packets(kCameras.size());
  DetectionMerger merger;
  VisionPacket geometry;
  fill_geometry(Field{}, kCameras, *geometry.mutable_geometry());
  merger.add(geometry, 0);
  std::vector<Frame> read;
  for (const Frame& frame : frames) {
    fill_detections(frame, kCameras, packets);
    for (const VisionPacket& packet : packets) {
      if (const Frame* done = merger.add(packet, frame.time_s)) read.push_back(*done);
    }
  }
  if (const Frame* done = merger.finish()) read.push_back(*done);
  return read;
}

bool are_equal(const Frame& one, const Frame& other) {
  const auto same_robots = [&](Side side) {
    return std::equal(one.robots[side].begin(), one.robots[side].end(), other.robots[side].begin(),
                      other.robots[side].end(), [](const auto& a, const auto& b) {
                        return a.number == b.number && a.position_m == b.position_m &&
                               a.heading == b.heading;
                      });
  };
  return one.number == other.number && one.time_s == other.time_s && same_robots(Side::kWest) &&
         same_robots(Side::kEast) && one.ball.has_value() == other.ball.has_value() &&
         (!one.ball || (one.ball->position_m == other.ball->position_m &&
                        one.ball->height_m == other.ball->height_m));
}

TEST(FrameHistory, IsReadBackBitForBit) {
  std::vector<Frame> frames;
  for (int i = 0; i < 5; ++i) frames.push_back(busy_frame(i));
  frames[2].ball.reset();
  frames[3].robots[Side::kEast].clear();
  const std::vector<Frame> read = sent_and_read(frames);
  ASSERT_EQ(read.size(), frames.size());
  for (std::size_t i = 0; i < read.size(); ++i) EXPECT_TRUE(are_equal(read[i], frames[i])) << i;
}

TEST(FrameHistory, NamesTheCameraOfABallWithoutHeight) {
  Frame frame = busy_frame();
  frame.ball = BallObservation{{0.2, 0.1}, std::nullopt, kCameras[0]};
  const std::vector<Frame> read = sent_and_read({frame});
  ASSERT_EQ(read.size(), 1U);
  EXPECT_FALSE(read[0].ball->height_m.has_value());
  EXPECT_EQ(read[0].ball->seen_from.position_m, kCameras[0].position_m);
}

// A false ball and a robot with a misread number are in the packets, but not in the merged frames.
TEST(FrameHistory, IsReadBackAmongOtherDetections) {
  const Frame frame = busy_frame();
  OtherDetections others;
  others.balls.push_back({{1.2, 0.8}, std::nullopt, kCameras[3]});
  others.robots[Side::kEast].push_back({2, {-1, -1}, {1, 0}});
  std::vector<VisionPacket> packets(kCameras.size());
  fill_detections(frame, kCameras, packets, others);
  int balls = 0;
  int blue = 0;
  DetectionMerger merger;
  for (const VisionPacket& packet : packets) {
    balls += packet.detection().balls_size();
    blue += packet.detection().robots_blue_size();
    merger.add(packet, frame.time_s);
  }
  EXPECT_EQ(balls, 2);
  EXPECT_EQ(blue, 7);
  EXPECT_TRUE(are_equal(*merger.finish(), frame));
}

DetectionFrame detection(std::uint32_t camera, double capture_s) {
  DetectionFrame detection;
  detection.set_frame_number(1);
  detection.set_t_capture(capture_s);
  detection.set_t_sent(capture_s);
  detection.set_camera_id(camera);
  return detection;
}

void add_detection_of(DetectionFrame& detection, std::uint32_t id, float x, float confidence) {
  DetectionRobot& robot = *detection.add_robots_yellow();
  robot.set_robot_id(id);
  robot.set_x(x);
  robot.set_y(0);
  robot.set_orientation(0);
  robot.set_confidence(confidence);
}

VisionPacket vision_packet_of(const DetectionFrame& detection) {
  VisionPacket packet;
  *packet.mutable_detection() = detection;
  return packet;
}

TEST(DetectionMerger, TakesTheMostConfidentDetectionOfARobotSeenTwice) {
  DetectionFrame one = detection(0, 5);
  DetectionFrame other = detection(1, 5.003);
  add_detection_of(one, 3, 100, 0.7F);
  add_detection_of(other, 3, 200, 0.9F);
  DetectionMerger merger;
  merger.add(vision_packet_of(one), one.t_capture());
  merger.add(vision_packet_of(other), other.t_capture());
  const Frame* frame = merger.finish();
  ASSERT_NE(frame, nullptr);
  ASSERT_EQ(frame->robots[Side::kWest].size(), 1U);
  EXPECT_DOUBLE_EQ(frame->robots[Side::kWest][0].position_m.x(), 0.2);
}

TEST(DetectionMerger, IgnoresDetectionsThatAreNotLeagueRobots) {
  DetectionFrame one = detection(0, 5);
  add_detection_of(one, 16, 100, 1);
  add_detection_of(one, 2, std::nanf(""), 1);
  DetectionMerger merger;
  merger.add(vision_packet_of(one), one.t_capture());
  EXPECT_TRUE(merger.finish()->robots[Side::kWest].empty());
}

TEST(DetectionMerger, BeginsAFrameWhenACameraRepeatsOrAfterAGap) {
  DetectionMerger merger;
  EXPECT_EQ(merger.add(vision_packet_of(detection(0, 5)), 5), nullptr);
  EXPECT_EQ(merger.add(vision_packet_of(detection(1, 5.004)), 5.004), nullptr);
  EXPECT_NE(merger.add(vision_packet_of(detection(0, 5.016)), 5.016), nullptr);
  EXPECT_NE(merger.add(vision_packet_of(detection(1, 6)), 6), nullptr);
  EXPECT_DOUBLE_EQ(merger.finish()->time_s, 1);
}

TEST(DetectionMerger, IgnoresLatePackets) {
  DetectionMerger merger;
  merger.add(vision_packet_of(detection(0, 5)), 5);
  merger.add(vision_packet_of(detection(0, 6)), 6);
  EXPECT_EQ(merger.add(vision_packet_of(detection(0, 5.5)), 6.01), nullptr);
  EXPECT_EQ(merger.add(vision_packet_of(detection(1, std::nan(""))), 6), nullptr);
  EXPECT_EQ(merger.late(), 1);
  EXPECT_EQ(merger.unusable(), 1);
}

TEST(Geometry, DescribesTheFieldOfEveryRuleBook) {
  for (const std::string& book : rule_book_names()) {
    const Field field = find_game_setup(book)->field;
    Geometry geometry;
    fill_geometry(field, kCameras, geometry);
    const Field read = field_of(geometry);
    EXPECT_EQ(read.length_m, field.length_m) << book;
    EXPECT_EQ(read.run_off_m, field.run_off_m) << book;
    EXPECT_EQ(read.defence_area.shape, field.defence_area.shape) << book;
    EXPECT_NEAR(read.defence_area.depth_m, field.defence_area.depth_m, 1e-6) << book;
    EXPECT_NEAR(read.defence_area.straight_m, field.defence_area.straight_m, 1e-6) << book;
    EXPECT_EQ(read.penalty_mark_m, field.penalty_mark_m) << book;
  }
}

TEST(Geometry, RefusesAFieldOfZeroSize) {
  Geometry geometry;
  fill_geometry(Field{}, kCameras, geometry);
  geometry.mutable_field()->set_field_length(0);
  EXPECT_THROW(field_of(geometry), std::invalid_argument);
}

// Line numbers and names are those of the league's list of shapes.
TEST(Geometry, OfACameraAtAnImpossiblePositionIsIgnored) {
  Geometry geometry;
  fill_geometry(Field{}, kCameras, geometry);
  const Vec2 ball_m{0.2, 0.1};
  EXPECT_EQ(camera_of(geometry, 2, ball_m).position_m, kCameras[2].position_m);
  const float nowhere = std::numeric_limits<float>::quiet_NaN();
  for (const float height_mm : {nowhere, -4000.0F, 0.0F, 2e5F}) {
    geometry.mutable_calib(2)->set_derived_camera_world_tz(height_mm);
    EXPECT_EQ(camera_of(geometry, 2, ball_m).position_m, ball_m) << height_mm;
  }
  geometry.mutable_calib(3)->set_derived_camera_world_tx(nowhere);
  EXPECT_EQ(camera_of(geometry, 3, ball_m).position_m, ball_m);
}

TEST(Geometry, NumbersItsLinesAndArcsAsTheLeagueDoes) {
  Geometry geometry;
  fill_geometry(find_game_setup("2026-a")->field, kCameras, geometry);
  std::map<std::string, int> types;
  for (const FieldLine& line : geometry.field().field_lines()) types[line.name()] = line.type();
  for (const FieldArc& arc : geometry.field().field_arcs()) types[arc.name()] = arc.type();
  const std::map<std::string, int> expected = {{"CenterCircle", 1},
                                               {"TopTouchLine", 2},
                                               {"BottomTouchLine", 3},
                                               {"LeftGoalLine", 4},
                                               {"RightGoalLine", 5},
                                               {"HalfwayLine", 6},
                                               {"CenterLine", 7},
                                               {"LeftPenaltyStretch", 8},
                                               {"RightPenaltyStretch", 9},
                                               {"LeftFieldLeftPenaltyStretch", 10},
                                               {"LeftFieldRightPenaltyStretch", 11},
                                               {"RightFieldLeftPenaltyStretch", 12},
                                               {"RightFieldRightPenaltyStretch", 13}};
  EXPECT_EQ(types, expected);
}

TEST(FrameHistory, NamesItsSourceOther) {
  std::vector<VisionPacket> packets(kCameras.size());
  fill_detections(busy_frame(), kCameras, packets);
  // Field 3, a varint: 1.
  EXPECT_NE(packets[0].SerializeAsString().find("\x18\x01"), std::string::npos);
  EXPECT_EQ(packets[3].source(), 1);
}

// The league's numbers, checked without generated code: 300, 600 and 1000 mm as varints.
TEST(FieldMessage, HasTheMarginsOf2026UnderTheirNumbers) {
  Field field;
  field.run_off_m = 0.3;
  field.goal_line_run_off_m = 0.6;
  field.goal_substitution_area_m = 1.0;
  Geometry geometry;
  fill_geometry(field, {}, geometry);
  const std::string bytes = geometry.field().SerializeAsString();
  EXPECT_NE(bytes.find("\x28\xac\x02"), std::string::npos) << "5";
  EXPECT_NE(bytes.find("\x80\x01\xd8\x04"), std::string::npos) << "16";
  EXPECT_NE(bytes.find("\x88\x01\xe8\x07"), std::string::npos) << "17";
  const Field read = field_of(geometry);
  EXPECT_DOUBLE_EQ(read.run_off_m, 0.3);
  EXPECT_DOUBLE_EQ(read.goal_line_run_off_m, 0.6);
  EXPECT_DOUBLE_EQ(read.goal_substitution_area_m, 1.0);
}

TEST(FieldMessage, LeavesOutMarginsThatDoNotDiffer) {
  Geometry geometry;
  fill_geometry(Field{}, {}, geometry);
  EXPECT_FALSE(geometry.field().has_boundary_width_goal_line());
  EXPECT_FALSE(geometry.field().has_goal_substitution_area_width());
  EXPECT_DOUBLE_EQ(field_of(geometry).wall_x_m(), Field().wall_x_m());
  geometry.mutable_field()->set_boundary_width_goal_line(-600);
  EXPECT_THROW(field_of(geometry), std::invalid_argument);
}

}  // namespace
}  // namespace autoref::league
