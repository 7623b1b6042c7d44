#include "league/log_contents.hpp"

#include <set>

#include "league/messages/vision.pb.h"
#include "tests/league/scratch_log.hpp"

namespace autoref::league {
namespace {

class Cameras final : public LogVisitor {
 public:
  void on_vision(double /*time_s*/, const VisionPacket& packet) override {
    if (packet.has_detection()) seen.insert(packet.detection().camera_id());
  }
  std::set<std::uint32_t> seen;
};

std::string packet_of(std::uint32_t camera, double capture_s) {
  VisionPacket packet;
  DetectionFrame& detection = *packet.mutable_detection();
  detection.set_frame_number(1);
  detection.set_t_capture(capture_s);
  detection.set_t_sent(capture_s);
  detection.set_camera_id(camera);
  return packet.SerializeAsString();
}

// Writes the messages as a log, one millisecond apart.
const ScratchFile& written(const ScratchFile& file, MessageKind kind,
                           const std::vector<std::string>& messages) {
  LogWriter writer(file.path());
  std::int64_t time_ns = 0;
  for (const std::string& message : messages) writer.write(time_ns += 1'000'000, kind, message);
  writer.close();
  return file;
}

TEST(ReadLog, CountsUnreadableMessagesAndReportsTheFirst) {
  const ScratchFile file(".log");
  const std::string sound = packet_of(0, 1);
  written(file, MessageKind::kVision2014, {sound, "no packet", packet_of(0, 2), "nor this"});
  LogVisitor nobody;
  const LogSummary log = read_log(file.path(), nobody);
  EXPECT_EQ(log.frames, 2);
  EXPECT_EQ(log.faults.unreadable, 2);
  EXPECT_EQ(log.unreadable_at, static_cast<std::int64_t>(16 + 16 + sound.size()));
}

TEST(ReadLog, CountsUnrecognisedKindsAsUnknown) {
  const ScratchFile file(".log");
  written(file, static_cast<MessageKind>(1234), {"what", "is", "this"});
  LogVisitor nobody;
  const LogSummary log = read_log(file.path(), nobody);
  EXPECT_EQ(log.records.at(MessageKind::kUnknown), 3);
  EXPECT_EQ(log.records.size(), 1U);
}

// The single-size field of 2014, in the messages of 2010.
TEST(ReadLog, ReadsVisionOf2010) {
  VisionPacket2010 packet;
  packet.mutable_detection()->ParsePartialFromString(packet_of(0, 1).substr(2));
  FieldSize2010& size = *packet.mutable_geometry()->mutable_field();
  size.set_line_width(10);
  size.set_field_length(6050);
  size.set_field_width(4050);
  size.set_boundary_width(250);
  size.set_referee_width(425);
  size.set_goal_width(700);
  size.set_goal_depth(180);
  size.set_goal_wall_width(20);
  size.set_center_circle_radius(500);
  size.set_defense_radius(800);
  size.set_defense_stretch(350);
  size.set_free_kick_from_defense_dist(200);
  size.set_penalty_spot_from_field_line_dist(750);
  size.set_penalty_line_from_spot_dist(400);
  const ScratchFile file(".log");
  written(file, MessageKind::kVision2010, {packet.SerializeAsString()});
  LogVisitor nobody;
  const LogSummary log = read_log(file.path(), nobody);
  EXPECT_EQ(log.frames, 1);
  EXPECT_EQ(log.faults.unreadable, 0);
  const Field expected;
  ASSERT_TRUE(log.field);
  EXPECT_DOUBLE_EQ(log.field->length_m, expected.length_m);
  EXPECT_DOUBLE_EQ(log.field->run_off_m, 0.675);
  EXPECT_DOUBLE_EQ(log.field->penalty_mark_m, 0.75);
  EXPECT_EQ(log.field->defence_area.shape, DefenceArea::Shape::kQuarterCircles);
  EXPECT_NEAR(log.field->defence_area.depth_m, 0.8, 1e-6);
  EXPECT_NEAR(log.field->defence_area.straight_m, 0.35, 1e-6);
  EXPECT_FALSE(log.field_gaps.defence_area);
}

// The numbers of the league's fields, checked without generated code: 14 varints in order.
TEST(ReadLog, FindsTheSizesOf2010UnderTheirNumbers) {
  FieldSize2010 size;
  std::string bytes;
  for (char number = 1; number <= 14; ++number) bytes += {static_cast<char>(number << 3), number};
  ASSERT_TRUE(size.ParseFromString(bytes));
  EXPECT_EQ(size.field_length(), 2);
  EXPECT_EQ(size.referee_width(), 5);
  EXPECT_EQ(size.goal_depth(), 7);
  EXPECT_EQ(size.defense_radius(), 10);
  EXPECT_EQ(size.defense_stretch(), 11);
  EXPECT_EQ(size.penalty_spot_from_field_line_dist(), 13);
}

TEST(ReadLog, LimitsTheNumberOfCameras) {
  const ScratchFile file(".log");
  std::vector<std::string> messages;
  for (std::uint32_t camera = 0; camera < 1000; ++camera)
    messages.push_back(packet_of(camera * 12345, 1 + camera * 1e-4));
  written(file, MessageKind::kVision2014, messages);
  Cameras cameras;
  const LogSummary log = read_log(file.path(), cameras);
  EXPECT_EQ(cameras.seen.size(), 64U);
  EXPECT_EQ(log.faults.unreadable, 1000 - 64);
}

TEST(ReadLog, ComputesTheLengthFromTheRecordsTimes) {
  const ScratchFile file(".log");
  written(file, MessageKind::kReferee2013, {"", "", "", "", ""});
  LogVisitor nobody;
  EXPECT_DOUBLE_EQ(read_log(file.path(), nobody).length_s, 0.004);
}

// A log of 20 minutes has about 300,000 records, each with 8 bytes in the index.
void expect_index_skipped(const ScratchFile& file) {
  LogWriter writer(file.path());
  writer.write(5'000'000'000, MessageKind::kVision2014, packet_of(0, 1));
  writer.write(6'000'000'000, MessageKind::kVision2014, packet_of(0, 2));
  writer.write(0, MessageKind::kIndex2021, std::string(2'400'015, 'x'));
  writer.close();
  LogVisitor nobody;
  const LogSummary log = read_log(file.path(), nobody);
  EXPECT_EQ(log.records.at(MessageKind::kIndex2021), 1) << file.path();
  EXPECT_EQ(log.faults.unreadable, 0) << file.path();
  EXPECT_FALSE(log.damage) << file.path();
  EXPECT_DOUBLE_EQ(log.length_s, 1) << file.path();
}

TEST(ReadLog, SkipsTheIndexAtTheEndOfALog) {
  expect_index_skipped(ScratchFile(".log"));
  expect_index_skipped(ScratchFile(".log.gz"));
}

TEST(ReadLog, IsNotDamagedByAnIndexThatWasCutOff) {
  const ScratchFile file(".log");
  written(file, MessageKind::kVision2014, {packet_of(0, 1)});
  file.fill(file.bytes() + std::string("\0\0\0\0\0\0\0\0\0\0\0\6\0\0\0\x20"
                                       "half",
                                       20));
  LogVisitor nobody;
  const LogSummary log = read_log(file.path(), nobody);
  EXPECT_EQ(log.records.at(MessageKind::kIndex2021), 1);
  EXPECT_EQ(log.frames, 1);
  EXPECT_FALSE(log.damage);
}

TEST(ReadLog, StopsAtItsLimits) {
  const ScratchFile file(".log.gz");
  written(file, MessageKind::kUnknown, std::vector<std::string>(1000, std::string(10'000, 'x')));
  LogVisitor nobody;
  const LogSummary few = read_log(file.path(), nobody, {.records = 100});
  EXPECT_EQ(few.records.at(MessageKind::kUnknown), 100);
  EXPECT_EQ(few.damage->what, "more than 100 messages");
  const LogSummary small = read_log(file.path(), nobody, {.bytes = 1'000'000});
  EXPECT_LE(small.records.at(MessageKind::kUnknown), 101);
  EXPECT_EQ(small.damage->what, "more than 1000000 bytes once decompressed");
  EXPECT_FALSE(read_log(file.path(), nobody).damage);
}

}  // namespace
}  // namespace autoref::league
