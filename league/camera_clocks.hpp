// The clocks that cameras date their packets with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace autoref::league {

// Brings the packets of all cameras onto one clock, that of the frames: in seconds since the first
// packet was captured. Each camera may have a clock of its own, since several computers may run
// vision, and any clock may be set or restart.
//
// How far a clock is ahead is found by comparing when two packets arrived with when they were
// captured. Each camera is compared with the one of the lowest number that was heard within the
// last 0.1 s. Differences up to kSameClock_s are left alone: processing takes that much more or
// less time. A camera's first packet decides at once; then the median of 31 packets.
//
// A packet is not used if it is not newer than the camera's last one and the last frame, or if its
// clock is off by more than 0.1 s. If 20 of them in a row agree with each other, or five that are
// off by more than a second, the clock has changed: it continues with the time of arrival.
class CameraClocks {
 public:
  static constexpr double kSameClock_s = 0.01;
  // Packets of more cameras are ignored.
  static constexpr std::size_t kMostCameras = 64;
  static constexpr double kLongestGame_s = 1e6;

  // When the next packet was captured, which must be after `after_s`; nullopt if the packet is not
  // to be used. `capture_s` is on the camera's clock and finite; `received_s` is the packet's
  // arrival on the frames' clock.
  std::optional<double> time_s(std::uint32_t camera, double capture_s, double received_s,
                               double after_s);

  // Whether packets of the camera may be used: it is known, or there is room for another one.
  bool has_room_for(std::uint32_t camera) const;

  // The usual time between two packets of a camera; 0 while unknown.
  double interval_s(std::uint32_t camera) const { return clocks_.at(camera).interval_s; }

  // The capture time of the frames' time 0, by the clock of the camera with the lowest number;
  // nullopt before the first packet.
  std::optional<double> start_capture_s() const;

  // How far the clocks of the other cameras are ahead of that one, if that was adjusted.
  std::map<std::uint32_t, double> ahead_s() const;

  int cameras() const { return static_cast<int>(clocks_.size()); }
  int restarts() const { return restarts_; }  // several at the same time count once

 private:
  struct Clock {
    double start_s = 0;    // the capture time of the frames' time 0
    double capture_s = 0;  // of the last packet used
    double received_s = 0;
    double interval_s = 0;
    std::vector<double> ahead_s;  // of the reference, by the last packets
    int strays = 0;               // consecutive packets that agree with each other only
    double stray_capture_s = 0;
  };
  using Clocks = std::map<std::uint32_t, Clock>;

  Clocks::const_iterator reference(std::uint32_t camera, double received_s) const;
  Clock begun(std::uint32_t camera, double capture_s, double received_s) const;
  bool is_off(std::uint32_t camera, Clock& clock, double capture_s, double received_s);
  static std::optional<double> newer_s(const Clock& clock, double capture_s, double after_s);
  static bool is_established(Clock& clock, double capture_s, int strays);
  void restart(std::uint32_t camera, Clock& clock, double capture_s, double received_s,
               double after_s);
  static double ahead_s(const Clock& clock, const Clock& other, double capture_s,
                        double received_s);

  Clocks clocks_;
  double latest_s_ = 0;  // the latest packet
  double restarted_s_ = -kLongestGame_s;
  int restarts_ = 0;
};

}  // namespace autoref::league
