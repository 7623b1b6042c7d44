// Corrects for differences between the cameras' clocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace autoref::league {

// Brings the packets of all cameras onto one clock, that of the frames, in seconds since the first
// packet was captured. Each camera may have its own clock, since vision may run on several
// computers, and any clock may be set or restarted.
//
// To find how far one camera's clock is ahead of another, the times at which two packets arrived
// are compared with those at which they were captured. Each camera is compared with the
// lowest-numbered camera heard within the last 0.1 s. Differences up to kSameClock_s are left
// alone, since processing times vary by that much. A camera's first packet sets its clock's offset
// immediately; later, the median of 31 packets sets it.
//
// A packet is not used if it is not newer than the camera's last one, if it is more than kOld_s
// older than the last frame, or if its clock is off by more than 0.1 s from the clocks of the other
// cameras heard. If 20 such packets in a row arrive at the pace at which they were captured, or
// five that are off by more than a second, the clock counts as changed, and its times continue from
// the time of arrival. Delayed packets arrive all at once; in that case, it takes 250 packets.
//
// Clocks are not compared while packets arrive more slowly or faster than they were captured, as in
// slow or fast motion.
class CameraClocks {
 public:
  static constexpr double kSameClock_s = 0.01;
  static constexpr double kOld_s = 0.03;
  // Packets from more cameras than this are ignored.
  static constexpr std::size_t kMaxCameras = 64;
  static constexpr double kLongestGame_s = 1e6;
  static constexpr double kLatestCapture_s = 1e12;  // later times lose their milliseconds

  // The capture time of the next packet on the frames' clock; nullopt if the packet must not be
  // used. `capture_s` is on the camera's clock, and at most kLatestCapture_s from 0; `received_s`
  // is the packet's arrival on the frames' clock. `after_s` is the time of the last frame.
  std::optional<double> time_s(std::uint32_t camera, double capture_s, double received_s,
                               double after_s);

  // Whether packets from the camera can be used: the camera is known, or another camera can be
  // added.
  bool has_room_for(std::uint32_t camera) const;

  // The number of cameras heard so far.
  std::size_t cameras() const { return clocks_.size(); }

  // The usual time between two packets of a camera; 0 while unknown.
  double interval_s(std::uint32_t camera) const { return clocks_.at(camera).interval_s; }

  // The capture time of the frames' time 0, on the clock of the first camera with 31 used packets,
  // or, until there is such a camera, on the clock of the first camera; nullopt before the first
  // packet.
  std::optional<double> start_capture_s() const;

  // How far the clocks of other cameras are ahead of the clock of start_capture_s(), for those that
  // were corrected.
  std::map<std::uint32_t, double> ahead_s() const;

  int restarts() const { return restarts_; }  // simultaneous restarts count once

 private:
  // When a packet was captured, on its camera's clock, and when it arrived.
  struct Heard {
    double capture_s = 0;
    double received_s = 0;
  };
  struct Clock {
    double start_s = 0;              // the capture time of the frames' time 0
    std::optional<Heard> last;       // the last packet used
    std::optional<Heard> before;     // a packet from about a second before `last`
    std::optional<bool> keeps_pace;  // whether packets arrive at the pace of their capture; nullopt
                                     // while unknown
    int used = 0;                    // number of packets used
    double interval_s = 0;
    // How far the clock is ahead of the reference, for each of the last packets.
    std::vector<double> ahead_s;
    int strays = 0;  // consecutive packets that could not be used
    Heard first_stray;
    Heard last_stray;
  };
  using Clocks = std::map<std::uint32_t, Clock>;

  static bool is_heard(const Clock& clock, double received_s);
  static double ahead_s(const Clock& clock, const Clock& other, const Heard& heard);
  Clocks::const_iterator reference(std::uint32_t camera, double received_s) const;
  std::optional<double> ahead_of_others_s(std::uint32_t camera, const Heard& heard,
                                          bool counts_unknown) const;
  Clock first_clock(std::uint32_t camera, const Heard& heard) const;
  bool is_off(std::uint32_t camera, const Heard& heard) const;
  void compare(std::uint32_t camera, const Heard& heard);
  static std::optional<double> time_if_newer_s(const Clock& clock, double capture_s,
                                               double after_s);
  bool has_changed(Clock& clock, const Heard& heard) const;
  void restart(std::uint32_t camera, const Heard& heard, double after_s);
  void use(std::uint32_t camera, const Heard& heard);

  Clocks clocks_;
  std::optional<std::uint32_t> epoch_;  // the camera on whose clock the frames' time 0 is given
  double latest_s_ = 0;                 // time of the latest packet
  double restarted_s_ = -kLongestGame_s;
  int restarts_ = 0;
};

}  // namespace autoref::league
