#include "league/camera_clocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "league/detection_merger.hpp"

namespace autoref::league {
namespace {

constexpr int kRate_hz = 60;
constexpr std::uint32_t kCameraCount = 4;
constexpr double kBegin_s = 1.5e9;  // a Unix time
constexpr int kFrames = 20 * kRate_hz;

// Packets of four cameras, 3 ms apart from each other. Times are true ones.
struct PacketStream {
  // On the clock of the camera's computer.
  std::function<double(std::uint32_t camera, double time_s)> capture_s =
      [](std::uint32_t, double time_s) { return time_s; };
  std::function<double(std::uint32_t camera, double time_s)> arrival_s =
      [](std::uint32_t, double time_s) { return time_s; };
  std::function<bool(std::uint32_t camera, int frame)> is_lost = [](std::uint32_t, int) {
    return false;
  };
};

struct MergedStream {
  int frames = 0;
  std::set<double> frame_times_s;
  double latest_s = 0;
  std::int64_t late = 0;
  int restarts = 0;
  std::map<std::uint32_t, double> ahead_s;
};

double taken_s(std::uint32_t camera, int frame) {
  return 0.003 * camera + static_cast<double>(frame) / kRate_hz;
}

using Arrivals = std::vector<std::pair<double, VisionPacket>>;

Arrivals packets_of(const PacketStream& stream) {
  Arrivals arrivals;
  for (int frame = 0; frame < kFrames; ++frame) {
    for (std::uint32_t camera = 0; camera < kCameraCount; ++camera) {
      if (stream.is_lost(camera, frame)) continue;
      const double time_s = taken_s(camera, frame);
      VisionPacket packet;
      packet.mutable_detection()->set_camera_id(camera);
      packet.mutable_detection()->set_t_capture(stream.capture_s(camera, kBegin_s + time_s));
      arrivals.emplace_back(stream.arrival_s(camera, time_s), std::move(packet));
    }
  }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return arrivals;
}

MergedStream merged(const PacketStream& stream) {
  DetectionMerger merger;
  MergedStream result;
  const auto note = [&result](const Frame* frame) {
    if (frame == nullptr) return;
    EXPECT_GT(frame->time_s, result.frames == 0 ? -1 : result.latest_s);
    result.latest_s = frame->time_s;
    result.frame_times_s.insert(frame->time_s);
    ++result.frames;
  };
  for (const auto& [arrival_s, packet] : packets_of(stream)) note(merger.add(packet, arrival_s));
  note(merger.finish());
  EXPECT_EQ(merger.unusable(), 0);
  result.late = merger.late();
  result.restarts = merger.clocks().restarts();
  result.ahead_s = merger.clocks().ahead_s();
  return result;
}

void expect_all_used(const MergedStream& result) {
  EXPECT_EQ(result.late, 0);
  EXPECT_EQ(result.frames, kFrames);
  EXPECT_EQ(result.restarts, 0);
}

TEST(CameraClocks, OneClockIsLeftAlone) {
  const MergedStream result = merged({});
  expect_all_used(result);
  EXPECT_TRUE(result.ahead_s.empty());
}

TEST(CameraClocks, ALostPacketCostsNothingElse) {
  for (std::uint32_t lost = 0; lost < 4; ++lost) {
    PacketStream stream;
    stream.is_lost = [lost](std::uint32_t camera, int frame) {
      return camera == lost && frame == 30;
    };
    expect_all_used(merged(stream));
  }
}

TEST(CameraClocks, ManyLostPacketsCostNothingElse) {
  PacketStream stream;
  stream.is_lost = [](std::uint32_t camera, int frame) {
    return (frame * 7 + static_cast<int>(camera) * 13) % 20 == 0;
  };
  const MergedStream result = merged(stream);
  EXPECT_EQ(result.late, 0);
  // A frame may begin with another camera afterwards.
  EXPECT_NEAR(result.frames, kFrames, kFrames / 10);
}

class ClockApart : public testing::TestWithParam<double> {};

TEST_P(ClockApart, IsAdjusted) {
  PacketStream stream;
  stream.capture_s = [](std::uint32_t camera, double time_s) {
    return time_s + (camera >= 2 ? GetParam() : 0);
  };
  const MergedStream result = merged(stream);
  expect_all_used(result);
  ASSERT_EQ(result.ahead_s.size(), 2U);
  EXPECT_NEAR(result.ahead_s.at(2), GetParam(), 1e-3);
  EXPECT_NEAR(result.ahead_s.at(3), GetParam(), 1e-3);
  EXPECT_NEAR(result.latest_s, taken_s(3, kFrames - 1), 0.001);
}

TEST_P(ClockApart, IsAdjustedWhenItIsSetDuringTheGame) {
  PacketStream stream;
  stream.capture_s = [](std::uint32_t camera, double time_s) {
    return time_s + (camera >= 2 && time_s > kBegin_s + 5 ? GetParam() : 0);
  };
  const MergedStream result = merged(stream);
  EXPECT_LE(result.late, 2 * 20);
  EXPECT_NEAR(result.frames, kFrames, 2);
  EXPECT_EQ(result.restarts, std::abs(GetParam()) > 1 ? 1 : 0);
  EXPECT_NEAR(result.ahead_s.at(2), GetParam(), 0.011);
  EXPECT_NEAR(result.latest_s, taken_s(3, kFrames - 1), 0.04);
}

INSTANTIATE_TEST_SUITE_P(All, ClockApart,
                         testing::Values(-86400.0, -0.5, -0.03, 0.02, 0.03, 0.5, 86400.0),
                         [](const auto& apart) {
                           const double size_ms = 1000 * std::abs(apart.param);
                           return std::to_string(std::lround(size_ms)) +
                                  (apart.param < 0 ? "msBehind" : "msAhead");
                         });

// A thousand parts in a million are far more than any computer's clock has.
TEST(CameraClocks, AClockThatRunsFastIsFollowed) {
  PacketStream stream;
  stream.capture_s = [](std::uint32_t camera, double time_s) {
    return camera == 1 ? kBegin_s + (time_s - kBegin_s) * 1.001 : time_s;
  };
  const MergedStream result = merged(stream);
  EXPECT_EQ(result.late, 0);
  EXPECT_NEAR(result.frames, kFrames, 3);
  EXPECT_NEAR(result.ahead_s.at(1), 0.02, 0.011);
}

// For 0.3 s, nothing comes from one camera; then everything at once.
TEST(CameraClocks, APauseOfOneConnectionChangesNoClockForLong) {
  for (std::uint32_t slow = 0; slow < 4; ++slow) {
    PacketStream stream;
    stream.arrival_s = [slow](std::uint32_t camera, double time_s) {
      const bool waits = camera == slow && time_s > 5 && time_s < 5.3;
      return waits ? 5.3 : time_s;
    };
    const MergedStream result = merged(stream);
    EXPECT_LE(result.late, 20) << slow;
    EXPECT_GE(result.frames, kFrames - 2) << slow;
    EXPECT_TRUE(result.ahead_s.empty()) << slow;
    EXPECT_EQ(result.restarts, 0) << slow;
  }
}

// A simulation sends all packets of a frame at once.
TEST(CameraClocks, SlowMotionAndFastMotionAreNoDifferenceOfClocks) {
  for (const double speed : {0.01, 0.1, 0.3, 3.0, 100.0, 1e6}) {
    PacketStream stream;
    stream.arrival_s = [speed](std::uint32_t camera, double time_s) {
      return (time_s - taken_s(camera, 0)) / speed;
    };
    const MergedStream result = merged(stream);
    expect_all_used(result);
    EXPECT_TRUE(result.ahead_s.empty()) << speed;
  }
}

TEST(CameraClocks, ACameraThatComesLaterIsAdjusted) {
  PacketStream stream;
  stream.is_lost = [](std::uint32_t camera, int frame) { return camera == 0 && frame < 600; };
  stream.capture_s = [](std::uint32_t camera, double time_s) {
    return time_s - (camera == 0 ? 100 : 0);
  };
  const MergedStream result = merged(stream);
  expect_all_used(result);
  EXPECT_NEAR(result.ahead_s.at(3), 100, 1e-3);
}

}  // namespace
}  // namespace autoref::league
