// Merges the packets of several cameras into frames of the whole field.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "league/camera_clocks.hpp"
#include "league/field_message.hpp"
#include "league/followed_body.hpp"
#include "league/messages/vision.pb.h"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::league {

// A frame consists of one packet per camera, and its time is that of the latest packet. The next
// frame begins when a camera that is already in the frame sends another packet, or after a gap of
// 0.1 s. It also begins when the frame is older than the captures of n freely running cameras are
// if it begins after their longest pause, which is at most a share of 1 - 1/n of their interval.
// So a lost packet affects no later frames, and two cameras are merged alike from any packet on,
// unless they are within a twentieth of their interval of taking turns. Clocks that differ or
// restart are corrected (camera_clocks.hpp).
//
// For a robot seen by several cameras, one camera is used, and a change to another causes no jump
// (followed_body.hpp). If a robot appears twice, the detection nearest to its expected position is
// used, unless another has a clearly higher confidence. If there are several balls, one of them is
// followed (followed_body.hpp). The merger ignores robots with a number outside the league's range,
// detections that are not finite or more than 100 m away, and frames more than a million seconds
// after the first.
class DetectionMerger {
 public:
  // Adds the next packet, which arrived at `received_s` on the frames' clock. Returns the frame
  // that it completes, or nullptr; the frame is valid until the next call. Frames are numbered from
  // 0 in order of arrival. Their times are in seconds since the first frame and increase.
  const Frame* add(const VisionPacket& packet, double received_s);

  // Completes the last frame; nullptr if there is none.
  const Frame* finish();

  // The field in the most recent valid geometry.
  const std::optional<Field>& field() const { return field_; }

  // The optional parts that are missing from the most recent valid geometry.
  const FieldGaps& field_gaps() const { return field_gaps_; }
  // How often the field has changed since the first geometry.
  int field_changes() const { return field_changes_; }
  // The number of detections of robots whose number is outside the league's range.
  std::int64_t unnumbered() const { return unnumbered_; }

  const CameraClocks& clocks() const { return clocks_; }

  // The number of packets that were ignored because they are not newer than those already used, or
  // because their clock is not known yet.
  std::int64_t late() const { return late_; }
  // The number of packets that were ignored for other reasons.
  std::int64_t unusable() const { return unusable_; }

 private:
  struct Robot {
    FollowedBody body;
    std::vector<Detected> seen;  // detections of this robot in the current frame
  };

  void read_geometry(const Geometry& geometry);
  void forget(std::uint32_t camera);
  bool begins_frame(std::uint32_t camera, double time_s) const;
  void collect(const DetectionFrame& detection, double time_s);
  void collect_robots(const DetectionFrame& detection, Side side);
  void collect_ball(const DetectionBall& ball, std::uint32_t camera);
  std::optional<RobotObservation> robot_seen(int number, Robot& robot);
  std::optional<BallObservation> ball_seen();
  const Frame* complete();

  std::optional<Field> field_;
  FieldGaps field_gaps_;
  int field_changes_ = 0;
  Geometry geometry_;
  CameraClocks clocks_;
  std::set<std::uint32_t> in_frame_;  // cameras that contributed to the current frame
  PerSide<std::array<Robot, kMaxRobots>> robots_;
  BallChoice ball_choice_;
  std::vector<Detected> balls_;                        // balls in the current frame
  std::vector<std::optional<double>> ball_heights_m_;  // height of each of these balls
  double last_time_s_ = -1;
  std::int64_t unnumbered_ = 0;
  double begun_s_ = 0;  // time of the first packet of the current frame
  double time_s_ = 0;   // time of the latest packet in the current frame
  // Packet interval of the camera that sent the current frame's first packet.
  double interval_s_ = 0;
  std::int64_t frames_ = 0;
  std::int64_t late_ = 0;
  std::int64_t unusable_ = 0;
  Frame frame_;
};

}  // namespace autoref::league
