#include "live/referee/live_referee.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "benchmarks/beside_live_game.hpp"
#include "league/field_message.hpp"
#include "league/messages/vision.pb.h"
#include "live/network/network.hpp"

namespace autoref::live {
namespace {

constexpr std::int64_t kMostGathered = 50'000;  // packets that are judged once the field is known
constexpr std::int64_t kOthers = kMostGathered + 100;
constexpr std::int64_t kFrames = 10;
constexpr std::int64_t kMostWaits = 3000;  // of 20 ms each

std::string vision_packet(std::uint32_t frame) {
  league::VisionPacket packet;
  league::fill_geometry(Field{}, {}, *packet.mutable_geometry());
  league::DetectionFrame& detection = *packet.mutable_detection();
  detection.set_frame_number(frame);
  detection.set_camera_id(0);
  detection.set_t_capture(1 + frame / 60.0);
  detection.set_t_sent(1 + frame / 60.0);
  return packet.SerializeAsString();
}

// It may be started long before vision, beside a referee that sends all the time.
TEST(LiveReferee, StartsWhenVisionBeginsAfterMorePacketsThanItKeeps) {
  NetworkThread thread;
  const std::vector<int> ports = benchmarks::free_ports(thread, 2);
  LiveRefereeOptions options;
  options.ports.vision = ports[0];
  options.ports.referee = ports[1];
  LiveReferee referee(options);
  const std::string everybody = *broadcast_address(kLoopback);
  DatagramSender others(kLoopback, {everybody, options.ports.referee});
  DatagramSender vision(kLoopback, {everybody, options.ports.vision});
  std::int64_t calls = 0;
  std::int64_t most_gathered = 0;
  const logs::RecordedFacts facts = referee.gather([&](std::int64_t gathered) {
    most_gathered = std::max(most_gathered, gathered);
    if (++calls <= kOthers) others.send("not a referee packet");
    if (calls > kOthers && calls <= kOthers + kFrames)
      vision.send(vision_packet(static_cast<std::uint32_t>(calls - kOthers)));
    if (calls > kOthers + kMostWaits) throw std::runtime_error("it does not start");
  });
  EXPECT_GT(calls, kOthers);
  EXPECT_EQ(most_gathered, kMostGathered);
  EXPECT_GT(facts.log.frames, 0);
  EXPECT_TRUE(facts.log.field);
}

}  // namespace
}  // namespace autoref::live
