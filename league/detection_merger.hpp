// From the packets of several cameras to whole frames of the field.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>

#include "league/field_message.hpp"
#include "league/messages/vision.pb.h"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::league {

// A frame is made of one packet of each camera: the next begins when a camera comes again, or
// after a gap of 0.1 s. Of a robot that several cameras see, the surest detection counts, and of
// several balls the one nearest to where the ball was last. Left out are detections that are no
// robots of the league, or no numbers or more than 100 m away, and frames a million seconds after
// the first. If the cameras' clock restarts in the middle of a log, times continue from where
// they were once a row of packets agrees on the new clock.
class DetectionMerger {
 public:
  // Takes the next packet. The frame that it completes is returned; it is valid until the next
  // call. Frames are numbered from 0 in the order in which they come, their times count from the
  // first, in seconds, and grow: packets older than the last frame are left out. `received_s` is
  // when the packet came, on the frames' clock: where a new clock of the cameras goes on.
  const Frame* add(const VisionPacket& packet, double received_s = 0);

  // The frame that is not complete yet; none where there is none.
  const Frame* finish();

  // As of the last geometry that made sense.
  const std::optional<Field>& field() const { return field_; }

  // What that geometry leaves out.
  const FieldGaps& field_gaps() const { return field_gaps_; }
  // How often another field came after the first.
  int field_changes() const { return field_changes_; }
  // How often the cameras' clock restarted.
  int clock_restarts() const { return clock_restarts_; }
  // Detections of robots with a number that the league does not have.
  std::int64_t unnumbered() const { return unnumbered_; }

  int cameras() const { return static_cast<int>(cameras_.size()); }
  std::int64_t unusable() const { return unusable_; }  // packets that were left out

 private:
  struct RobotDetection {
    RobotObservation robot;
    float confidence = -1;  // negative: not seen
  };
  struct BallDetection {
    BallObservation ball;
    float confidence = 0;
  };

  void read_geometry(const Geometry& geometry);
  bool is_usable(const DetectionFrame& detection) const;
  bool restarts_clock(const DetectionFrame& detection, double received_s);
  bool restarts_clock(const DetectionFrame& detection) const;
  void collect(const DetectionFrame& detection);
  void collect_robots(const DetectionFrame& detection, Side side);
  void collect_ball(const DetectionBall& ball, std::uint32_t camera);
  const Frame* complete();

  std::optional<Field> field_;
  FieldGaps field_gaps_;
  int field_changes_ = 0;
  Geometry geometry_;
  std::set<std::uint32_t> cameras_;   // all so far
  std::set<std::uint32_t> in_frame_;  // those that the frame at hand has
  PerSide<std::array<RobotDetection, kMaxRobots>> robots_;
  std::optional<BallDetection> ball_;
  std::optional<Vec2> last_ball_m_;
  std::optional<double> first_capture_s_;
  double last_time_s_ = -1;
  int strays_ = 0;  // packets in a row that agree on another clock
  double stray_capture_s_ = 0;
  int clock_restarts_ = 0;
  std::int64_t unnumbered_ = 0;
  double time_s_ = 0;  // of the frame at hand
  std::int64_t frames_ = 0;
  std::int64_t unusable_ = 0;
  Frame frame_;
};

}  // namespace autoref::league
