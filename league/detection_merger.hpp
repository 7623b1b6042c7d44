// Merges the packets of several cameras into frames of the whole field.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "league/ball_choice.hpp"
#include "league/field_message.hpp"
#include "league/followed_body.hpp"
#include "league/messages/vision.pb.h"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::league {

// Packets of more cameras are ignored.
inline constexpr std::size_t kMostCameras = 64;

// A frame consists of one packet per camera. The next frame begins when a camera sends another
// packet, or after a gap of 0.1 s. A robot that several cameras see stays with its camera, and
// changes to another without a jump (followed_body.hpp). If it appears twice, the detection nearest
// to where it is expected is used, unless another is clearly more confident. Of several balls, one
// is followed (ball_choice.hpp). Ignores robots
// with a number outside the league's range, detections that are not finite or more than 100 m away,
// and frames more than a million seconds after the first. If the cameras' clock restarts within a
// log, times continue from the previous ones once enough consecutive packets agree on the new
// clock.
class DetectionMerger {
 public:
  // Adds the next packet. Returns the frame that it completes, or nullptr; the frame is valid until
  // the next call. Frames are numbered from 0 in order of arrival. Their times are in seconds since
  // the first frame and increase: packets older than the last frame are ignored. `received_s` is
  // the packet's arrival time on the frames' clock, from which times continue if the cameras' clock
  // restarts.
  const Frame* add(const VisionPacket& packet, double received_s = 0);

  // Completes the last frame; nullptr if there is none.
  const Frame* finish();

  // The field in the most recent valid geometry.
  const std::optional<Field>& field() const { return field_; }

  // The optional parts that the most recent valid geometry omits.
  const FieldGaps& field_gaps() const { return field_gaps_; }
  // How often the field changed after the first geometry.
  int field_changes() const { return field_changes_; }
  // How often the cameras' clock restarted.
  int clock_restarts() const { return clock_restarts_; }
  // Detections of robots with a number outside the league's range.
  std::int64_t unnumbered() const { return unnumbered_; }

  // The Unix time of the first frame, by the cameras' clock; nullopt before it.
  const std::optional<double>& first_capture_s() const { return first_capture_s_; }

  int cameras() const { return static_cast<int>(cameras_.size()); }
  std::int64_t unusable() const { return unusable_; }  // packets that were ignored

 private:
  struct Robot {
    FollowedBody body;
    std::vector<Detected> seen;  // in the current frame
  };

  void read_geometry(const Geometry& geometry);
  bool is_usable(const DetectionFrame& detection) const;
  bool restarts_clock(const DetectionFrame& detection, double received_s);
  bool restarts_clock(const DetectionFrame& detection) const;
  void collect(const DetectionFrame& detection);
  void collect_robots(const DetectionFrame& detection, Side side);
  void collect_ball(const DetectionBall& ball, std::uint32_t camera);
  std::optional<RobotObservation> robot_seen(int number, Robot& robot);
  std::optional<BallObservation> ball_seen();
  const Frame* complete();

  std::optional<Field> field_;
  FieldGaps field_gaps_;
  int field_changes_ = 0;
  Geometry geometry_;
  std::set<std::uint32_t> cameras_;   // seen so far
  std::set<std::uint32_t> in_frame_;  // cameras that contributed to the current frame
  PerSide<std::array<Robot, kMaxRobots>> robots_;
  BallChoice ball_choice_;
  std::vector<Detected> balls_;                        // in the current frame
  std::vector<std::optional<double>> ball_heights_m_;  // of each
  std::optional<double> first_capture_s_;
  double last_time_s_ = -1;
  int strays_ = 0;  // consecutive packets that agree on another clock
  double stray_capture_s_ = 0;
  int clock_restarts_ = 0;
  std::int64_t unnumbered_ = 0;
  double time_s_ = 0;  // time of the current frame
  std::int64_t frames_ = 0;
  std::int64_t unusable_ = 0;
  Frame frame_;
};

}  // namespace autoref::league
