#include "league/record_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "league/referee_message.hpp"

namespace autoref::league {
namespace {

// What reaches those who use the messages.
class Received final : public LogVisitor {
 public:
  void on_vision(double /*time_s*/, const VisionPacket& /*packet*/) override { ++vision; }
  void on_tracks(const Frame& /*frame*/, const Tracks& /*tracks*/) override { ++tracks; }
  void on_referee(double /*time_s*/, const RefereePacket& packet) override {
    commands.push_back(packet.command_counter());
  }
  int vision = 0;
  int tracks = 0;
  std::vector<std::uint32_t> commands;
};

class ReaderOfRecords : public testing::Test {
 protected:
  std::string vision_at(double capture_s) {
    VisionPacket packet;
    DetectionFrame& detection = *packet.mutable_detection();
    detection.set_frame_number(1);
    detection.set_t_capture(capture_s);
    detection.set_t_sent(capture_s);
    detection.set_camera_id(0);
    return packet.SerializeAsString();
  }
  std::string command(std::uint32_t counter, double sent_s, const std::string& source = "") {
    RefereePacket packet;
    fill_referee({}, {}, sent_s, packet);
    packet.set_command_counter(counter);
    packet.set_packet_timestamp(static_cast<std::uint64_t>(std::llround(1e6 * sent_s)));
    if (!source.empty()) packet.set_source_identifier(source);
    return packet.SerializeAsString();
  }
  ReadResult read_vision(double capture_s) {
    return reader_.read(MessageKind::kVision2014, vision_at(capture_s), capture_s);
  }
  ReadResult read_command(const std::string& bytes, double now_s, const std::string& sender = "") {
    return reader_.read(MessageKind::kReferee2013, bytes, now_s, sender);
  }

  Received received_;
  RecordReader reader_{received_, false};
};

// By two interfaces, of which one is a few packets slower.
TEST_F(ReaderOfRecords, ShowsNoCopies) {
  std::vector<std::string> sent;
  for (int i = 0; i < 100; ++i) {
    sent.push_back(vision_at(5 + i / 60.0));
    reader_.read(MessageKind::kVision2014, sent.back(), i / 60.0);
    if (i >= 10) reader_.read(MessageKind::kVision2014, sent[sent.size() - 10], i / 60.0);
  }
  EXPECT_EQ(received_.vision, 100);
  EXPECT_EQ(reader_.faults().copies, 90);
  EXPECT_EQ(reader_.faults().late, 0);
  const std::string stop = command(2, 10);
  EXPECT_EQ(read_command(stop, 10), ReadResult::kUsed);
  EXPECT_EQ(read_command(stop, 10.01), ReadResult::kCopy);
  TrackerPacket tracker;
  tracker.set_uuid("tracker");
  tracker.mutable_tracked_frame()->set_frame_number(1);
  tracker.mutable_tracked_frame()->set_timestamp(10);
  const std::string tracks = tracker.SerializeAsString();
  EXPECT_EQ(reader_.read(MessageKind::kTracker2020, tracks, 10), ReadResult::kUsed);
  EXPECT_EQ(reader_.read(MessageKind::kTracker2020, tracks, 10), ReadResult::kCopy);
  EXPECT_EQ(received_.tracks, 1);
}

TEST_F(ReaderOfRecords, TakesMessagesThatAreParsedForSeveralReaders) {
  Received others;
  RecordReader other(others, false);
  ParsedMessage message;
  const auto read_twice = [&](MessageKind kind, const std::string& bytes) {
    parse(kind, bytes, message);
    const ReadResult result = reader_.read(message, 5);
    EXPECT_EQ(other.read(message, 5), result);
    return result;
  };
  EXPECT_EQ(read_twice(MessageKind::kVision2014, vision_at(5)), ReadResult::kUsed);
  EXPECT_EQ(read_twice(MessageKind::kVision2014, vision_at(5)), ReadResult::kCopy);
  EXPECT_EQ(read_twice(MessageKind::kReferee2013, command(7, 5)), ReadResult::kUsed);
  EXPECT_EQ(read_twice(MessageKind::kReferee2013, "no packet"), ReadResult::kUnreadable);
  EXPECT_EQ(read_twice(MessageKind::kIndex2021, command(8, 5)), ReadResult::kUsed);
  EXPECT_EQ(others.vision, 1);
  EXPECT_EQ(received_.vision, 1);
  EXPECT_EQ(others.commands, (std::vector<std::uint32_t>{7}));
  EXPECT_EQ(received_.commands, others.commands);
}

TEST_F(ReaderOfRecords, DoesNotGoBackToAnOlderCommand) {
  read_command(command(1, 10), 10);
  read_command(command(2, 10.025), 10.1);
  EXPECT_EQ(read_command(command(1, 10.02), 10.101), ReadResult::kLate);
  EXPECT_EQ(received_.commands, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(reader_.faults().late, 1);
  // The controller's clock was set, by an hour.
  EXPECT_EQ(read_command(command(3, 10.05 - 3600), 10.2), ReadResult::kUsed);
}

TEST_F(ReaderOfRecords, FollowsOneRefereeUntilItIsSilent) {
  for (int i = 0; i < 40; ++i) {
    read_command(command(7, 0.025 * i, "field A"), 0.025 * i);
    EXPECT_EQ(read_command(command(1, 500 + 0.025 * i, "forgotten"), 0.025 * i + 0.01),
              ReadResult::kOtherReferee);
  }
  EXPECT_EQ(received_.commands, std::vector<std::uint32_t>(40, 7));
  EXPECT_EQ(reader_.faults().of_other_referee, 40);
  EXPECT_EQ(reader_.faults().referee, "field A");
  EXPECT_EQ(reader_.faults().other_referee, "forgotten");
  // "field A" is restarted under another name; the forgotten one was ended meanwhile.
  EXPECT_EQ(read_command(command(8, 1.5, "restarted"), 1.5), ReadResult::kOtherReferee);
  EXPECT_EQ(read_command(command(8, 2.1, "restarted"), 2.1), ReadResult::kUsed);
  EXPECT_EQ(reader_.faults().referee, "restarted");
}

TEST_F(ReaderOfRecords, DistinguishesUnnamedRefereesByAddress) {
  read_command(command(7, 1), 1, "10.0.0.1");
  EXPECT_EQ(read_command(command(1, 500), 1.01, "10.0.0.2"), ReadResult::kOtherReferee);
  EXPECT_EQ(read_command(command(7, 1.1), 1.1, "10.0.0.1"), ReadResult::kUsed);
  EXPECT_EQ(reader_.faults().other_referee, "10.0.0.2");
  // The same controller by another interface, whose copy comes first.
  EXPECT_EQ(read_command(command(8, 1.2), 1.2, "10.0.0.2"), ReadResult::kOtherReferee);
  EXPECT_EQ(read_command(command(8, 1.2), 1.201, "10.0.0.1"), ReadResult::kUsed);
}

TEST_F(ReaderOfRecords, CountsWhatItIgnores) {
  read_vision(5);
  read_vision(6);
  EXPECT_EQ(read_vision(5.5), ReadResult::kLate);
  EXPECT_EQ(reader_.read(MessageKind::kVision2014, "no packet", 6), ReadResult::kUnreadable);
  EXPECT_EQ(read_command("nor this", 6), ReadResult::kUnreadable);
  EXPECT_EQ(reader_.faults().late, 1);
  EXPECT_EQ(reader_.faults().unreadable, 2);
  EXPECT_EQ(received_.vision, 2);
}

}  // namespace
}  // namespace autoref::league
