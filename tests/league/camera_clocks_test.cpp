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
#include "soccer/random.hpp"

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
  double longest_gap_s = 0;
  std::int64_t late = 0;
  int restarts = 0;
  std::map<std::uint32_t, double> ahead_s;
};

double taken_s(std::uint32_t camera, int frame) {
  return 0.003 * camera + static_cast<double>(frame) / kRate_hz;
}

VisionPacket captured_packet(std::uint32_t camera, double capture_s) {
  VisionPacket packet;
  packet.mutable_detection()->set_camera_id(camera);
  packet.mutable_detection()->set_t_capture(capture_s);
  return packet;
}

using Arrivals = std::vector<std::pair<double, VisionPacket>>;

Arrivals packets_of(const PacketStream& stream) {
  Arrivals arrivals;
  for (int frame = 0; frame < kFrames; ++frame) {
    for (std::uint32_t camera = 0; camera < kCameraCount; ++camera) {
      if (stream.is_lost(camera, frame)) continue;
      const double time_s = taken_s(camera, frame);
      arrivals.emplace_back(stream.arrival_s(camera, time_s),
                            captured_packet(camera, stream.capture_s(camera, kBegin_s + time_s)));
    }
  }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return arrivals;
}

MergedStream merge(Arrivals arrivals) {
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  DetectionMerger merger;
  MergedStream result;
  const auto note = [&result](const Frame* frame) {
    if (frame == nullptr) return;
    EXPECT_GT(frame->time_s, result.frames == 0 ? -1e9 : result.latest_s);
    if (result.frames > 0)
      result.longest_gap_s = std::max(result.longest_gap_s, frame->time_s - result.latest_s);
    result.latest_s = frame->time_s;
    result.frame_times_s.insert(frame->time_s);
    ++result.frames;
  };
  for (const auto& [arrival_s, packet] : arrivals) note(merger.add(packet, arrival_s));
  note(merger.finish());
  EXPECT_EQ(merger.unusable(), 0);
  result.late = merger.late();
  result.restarts = merger.clocks().restarts();
  result.ahead_s = merger.clocks().ahead_s();
  return result;
}

MergedStream merge(const PacketStream& stream) { return merge(packets_of(stream)); }

void expect_all_used(const MergedStream& result) {
  EXPECT_EQ(result.late, 0);
  EXPECT_EQ(result.frames, kFrames);
  EXPECT_EQ(result.restarts, 0);
}

TEST(CameraClocks, OneClockIsLeftAlone) {
  const MergedStream result = merge(PacketStream());
  expect_all_used(result);
  EXPECT_TRUE(result.ahead_s.empty());
}

TEST(CameraClocks, ALostPacketCostsNothingElse) {
  for (std::uint32_t lost = 0; lost < 4; ++lost) {
    PacketStream stream;
    stream.is_lost = [lost](std::uint32_t camera, int frame) {
      return camera == lost && frame == 30;
    };
    expect_all_used(merge(stream));
  }
}

TEST(CameraClocks, ManyLostPacketsCostNothingElse) {
  PacketStream stream;
  stream.is_lost = [](std::uint32_t camera, int frame) {
    return (frame * 7 + static_cast<int>(camera) * 13) % 20 == 0;
  };
  const MergedStream result = merge(stream);
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
  const MergedStream result = merge(stream);
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
  const MergedStream result = merge(stream);
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
  const MergedStream result = merge(stream);
  EXPECT_EQ(result.late, 0);
  EXPECT_NEAR(result.frames, kFrames, 3);
  EXPECT_NEAR(result.ahead_s.at(1), 0.02, 0.011);
}

// For a while, nothing comes from one camera; then everything at once.
TEST(CameraClocks, PacketsThatWaitedAreLateAndChangeNoClock) {
  for (const double wait_s : {0.05, 0.3, 0.9, 1.2, 3.0}) {
    for (std::uint32_t slow = 0; slow < 4; ++slow) {
      PacketStream stream;
      stream.arrival_s = [=](std::uint32_t camera, double time_s) {
        const bool waits = camera == slow && time_s > 5 && time_s < 5 + wait_s;
        return waits ? 5 + wait_s : time_s;
      };
      const MergedStream result = merge(stream);
      EXPECT_LE(result.late, wait_s * kRate_hz) << wait_s << " " << slow;
      EXPECT_NEAR(result.frames, kFrames, 2) << wait_s << " " << slow;
      EXPECT_TRUE(result.ahead_s.empty()) << wait_s << " " << slow;
      EXPECT_EQ(result.restarts, 0) << wait_s << " " << slow;
      EXPECT_NEAR(result.latest_s, taken_s(3, kFrames - 1), 0.001) << wait_s << " " << slow;
    }
  }
}

// A simulation sends all packets of a frame at once, in any order of the cameras.
TEST(CameraClocks, PlaybackSpeedIsNotADifferenceOfClocks) {
  for (const bool is_descending : {false, true}) {
    for (const double speed : {0.01, 0.1, 0.2, 0.5, 0.8, 3.0, 10.0, 100.0, 1e6}) {
      PacketStream stream;
      stream.arrival_s = [=](std::uint32_t camera, double time_s) {
        const std::uint32_t place = is_descending ? kCameraCount - camera : camera;
        return (time_s - taken_s(camera, 0)) / speed + 1e-9 * place;
      };
      const MergedStream result = merge(stream);
      EXPECT_EQ(result.late, 0) << speed;
      EXPECT_NEAR(result.frames, kFrames, 2) << speed;
      EXPECT_TRUE(result.ahead_s.empty()) << speed;
    }
  }
}

// A recorded game that is sent more slowly or faster, with the phases of its cameras.
TEST(CameraClocks, AReplayAtAnotherSpeedIsUsedAsAWhole) {
  for (const double speed : {0.05, 0.1, 0.2, 0.5, 2.0, 10.0}) {
    PacketStream stream;
    stream.arrival_s = [speed](std::uint32_t, double time_s) { return time_s / speed; };
    const MergedStream result = merge(stream);
    EXPECT_EQ(result.late, 0) << speed;
    EXPECT_NEAR(result.frames, kFrames, 2) << speed;
  }
}

// All clocks at once: the vision computer is set, or the simulator restarted.
TEST(CameraClocks, ClocksThatAreSetTogetherContinue) {
  for (const double at_s : {0.5, 5.0}) {
    for (const double step_s : {-86400.0, -100.0, -0.5, 0.5, 100.0, 86400.0}) {
      PacketStream stream;
      stream.capture_s = [=](std::uint32_t, double time_s) {
        return time_s + (time_s > kBegin_s + at_s ? step_s : 0);
      };
      const MergedStream result = merge(stream);
      EXPECT_LE(result.late, kCameraCount * 21) << at_s << " " << step_s;
      EXPECT_GE(result.frames, kFrames - 45) << at_s << " " << step_s;
      EXPECT_NEAR(result.latest_s, taken_s(3, kFrames - 1), 0.6) << at_s << " " << step_s;
    }
  }
}

// Before it is known whether arrival keeps pace.
TEST(CameraClocks, AWrongTimeAtTheBeginningIsForgotten) {
  for (const double wrong_s : {0.0, kBegin_s + 30, kBegin_s + 900, kBegin_s + 0.5, 1e12, -1e12}) {
    for (const int at : {0, 1, 3, 30 * static_cast<int>(kCameraCount)}) {
      Arrivals arrivals = packets_of({});
      VisionPacket& packet = arrivals[static_cast<std::size_t>(at)].second;
      packet.mutable_detection()->set_t_capture(wrong_s);
      const MergedStream result = merge(std::move(arrivals));
      EXPECT_LE(result.late, 30) << wrong_s << " " << at;
      EXPECT_GE(result.frames, kFrames - 25) << wrong_s << " " << at;
      EXPECT_LE(result.longest_gap_s, 0.6) << wrong_s << " " << at;
    }
  }
}

// Cameras of their own rates, phases, latencies and jitter; none may be lost.
TEST(CameraClocks, UnlikeCamerasAreAllUsed) {
  struct Camera {
    double rate_hz;
    double phase_s;
    double latency_s;
  };
  const std::vector<std::vector<Camera>> setups = {
      {{30, 0.0034, 0.0028}, {60, 0.0015, 0.0003}, {75, 0.010, 0.0034}},
      {{60, 0.001, 0.004}, {60, 0.014, 0.001}, {60, 0.009, 0.008}, {60, 0.005, 0.0}},
      {{75, 0, 0.002}, {74.7, 0.006, 0.009}},
      {{100, 0.0, 0.001}, {100, 0.002, 0.004}, {100, 0.007, 0.0}, {100, 0.005, 0.009}}};
  RandomStream chance(1);
  for (const double jitter_s : {0.0, 0.005, 0.02}) {
    for (const std::vector<Camera>& setup : setups) {
      Arrivals arrivals;
      for (std::uint32_t camera = 0; camera < setup.size(); ++camera) {
        const Camera& its = setup[camera];
        double last_s = 0;
        for (int i = 0; i < 20 * its.rate_hz; ++i) {
          const double time_s = its.phase_s + i / its.rate_hz;
          last_s = std::max(last_s, time_s + its.latency_s + jitter_s * chance.uniform());
          arrivals.emplace_back(last_s, captured_packet(camera, kBegin_s + time_s));
        }
      }
      const MergedStream result = merge(std::move(arrivals));
      EXPECT_LT(static_cast<double>(result.late), 0.002 * 20 * 60) << jitter_s << setup[0].rate_hz;
      EXPECT_EQ(result.restarts, 0);
    }
  }
}

// One packet of an impossible time changes nothing but itself.
TEST(CameraClocks, AnImpossibleTimeCostsItsPacketOnly) {
  for (const double impossible_s : {0.0, 1e300, -1e300, 1e12, -1e12, 2e9, kBegin_s + 999'999.9}) {
    for (const std::uint32_t camera : {0U, 2U, 9U}) {
      Arrivals arrivals = packets_of({});
      const auto at = arrivals.begin() + 4 * 600;
      arrivals.insert(at, {at->first, captured_packet(camera, impossible_s)});
      DetectionMerger merger;
      std::int64_t frames = 0;
      for (const auto& [arrival_s, packet] : arrivals)
        frames += merger.add(packet, arrival_s) == nullptr ? 0 : 1;
      EXPECT_LE(merger.late() + merger.unusable(), 1) << impossible_s << " " << camera;
      EXPECT_NEAR(static_cast<double>(frames), kFrames, 3) << impossible_s << " " << camera;
      EXPECT_NEAR(*merger.clocks().start_capture_s(), kBegin_s, 1e-3);
      EXPECT_TRUE(merger.clocks().ahead_s().empty());
    }
  }
}

// The times of the frames of two cameras, of which camera 1 captures `age_s` before camera 0. The
// stream begins with packet `first` of them.
std::vector<double> freely_merged_s(double period_s, double age_s, int first) {
  DetectionMerger merger;
  std::vector<double> times_s;
  for (int i = first; i < 200; ++i) {
    const std::uint32_t camera = i % 2 == 0 ? 1 : 0;
    const double capture_s = kBegin_s + i / 2 * period_s - (camera == 1 ? age_s : 0.0);
    const Frame* frame = merger.add(captured_packet(camera, capture_s), capture_s - kBegin_s);
    if (frame != nullptr) times_s.push_back(frame->time_s + *merger.clocks().start_capture_s());
  }
  return times_s;
}

TEST(FreelyRunningCameras, AreMergedAlikeWhicheverPacketComesFirst) {
  constexpr double kPeriod_s = 0.015;
  for (const double share : {0.1, 0.3, 0.44}) {
    for (const int first : {0, 1}) {
      const std::vector<double> times_s = freely_merged_s(kPeriod_s, share * kPeriod_s, first);
      ASSERT_GT(times_s.size(), 90U);
      for (std::size_t i = 5; i < times_s.size(); ++i) {
        const double periods = (times_s[i] - kBegin_s) / kPeriod_s;
        ASSERT_NEAR(periods, std::round(periods), 1e-3) << share << ": not the time of camera 0";
        ASSERT_NEAR(times_s[i] - times_s[i - 1], kPeriod_s, 1e-6) << share;
      }
    }
  }
}

TEST(CameraClocks, ACameraThatComesLaterIsAdjusted) {
  PacketStream stream;
  stream.is_lost = [](std::uint32_t camera, int frame) { return camera == 0 && frame < 600; };
  stream.capture_s = [](std::uint32_t camera, double time_s) {
    return time_s - (camera == 0 ? 100 : 0);
  };
  const MergedStream result = merge(stream);
  expect_all_used(result);
  EXPECT_NEAR(result.ahead_s.at(0), -100, 1e-3);
}

}  // namespace
}  // namespace autoref::league
