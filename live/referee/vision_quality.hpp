// Measures the quality of vision, for the person who runs AutoRef at a real field.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "league/messages/vision.pb.h"
#include "soccer/frame.hpp"
#include "soccer/side.hpp"

namespace autoref::live {

// The quality of vision over the last kWindow_s seconds.
struct VisionReport {
  std::map<std::uint32_t, double> rates_hz;  // packets per second, by camera
  double ball_seen = 0;                      // share of the frames with a ball
  double robots_seen = 0;                    // detections per expected robot and frame
  std::optional<double> cameras_disagree_m;  // median distance between two cameras' detections
                                             // of a robot; nullopt if they see none together
};

// Examines the packets and frames of the last few seconds. Cameras beyond the first 16 are ignored.
class VisionQuality {
 public:
  static constexpr double kWindow_s = 5;

  // Times are in s and must increase.
  void add(double time_s, const league::VisionPacket& packet);
  void add(const Frame& frame);

  VisionReport report() const;

 private:
  struct FrameCount {
    double time_s = 0;
    bool has_ball = false;
    PerSide<int> robots;
  };
  struct Detected {
    double time_s = -1;
    std::uint32_t camera = 0;
    Vec2 position_m{0, 0};
  };
  struct Distance {
    double time_s = 0;
    double distance_m = 0;
  };

  void compare(double time_s, Side side, const league::DetectionFrame& detection);

  std::map<std::uint32_t, std::deque<double>> packets_;  // times of packets, by camera
  std::deque<FrameCount> frames_;
  PerSide<std::array<Detected, kMaxRobots>> latest_;
  std::deque<Distance> distances_;
};

// The report as one or two lines of text.
std::string text_of(const VisionReport& report);

}  // namespace autoref::live
