#include "league/camera_clocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autoref::league {
namespace {

// A camera heard within that time is a reference. A packet that is farther off has been delayed, or
// its clock was set.
constexpr double kOff_s = 0.1;
constexpr double kLeap_s = 1;          // larger steps are restarts
constexpr int kLeaps = 5;              // packets in a row that establish a clock that has restarted
constexpr int kStrays = 20;            // or is off
constexpr std::size_t kCompared = 31;  // packets, about half a second
constexpr double kLongestInterval_s = 0.1;
constexpr double kRestartPause_s = 0.2;  // at least, so that nothing seems to have moved at once
// How much a packet's interval counts in the usual one; packets may be missing in a longer one.
constexpr double kIntervalShare = 0.125;
constexpr double kGapShare = 0.01;
constexpr double kGap = 1.5;  // times the usual interval
constexpr double kNever_s = -std::numeric_limits<double>::infinity();

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

bool CameraClocks::has_room_for(std::uint32_t camera) const {
  return clocks_.size() < kMostCameras || clocks_.contains(camera);
}

std::optional<double> CameraClocks::start_capture_s() const {
  if (clocks_.empty()) return std::nullopt;
  return clocks_.begin()->second.start_s;
}

std::map<std::uint32_t, double> CameraClocks::ahead_s() const {
  std::map<std::uint32_t, double> ahead_s;
  for (const auto& [camera, clock] : clocks_) {
    const double apart_s = clock.start_s - clocks_.begin()->second.start_s;
    if (std::abs(apart_s) > kSameClock_s) ahead_s[camera] = apart_s;
  }
  return ahead_s;
}

// How far `clock` is ahead of another camera's, beyond what is known.
double CameraClocks::ahead_s(const Clock& clock, const Clock& other, double capture_s,
                             double received_s) {
  const double between_captures_s = (capture_s - clock.start_s) - (other.capture_s - other.start_s);
  return between_captures_s - (received_s - other.received_s);
}

CameraClocks::Clocks::const_iterator CameraClocks::reference(std::uint32_t camera,
                                                             double received_s) const {
  return std::find_if(clocks_.begin(), clocks_.end(), [&](const auto& one) {
    return one.first != camera && one.second.capture_s > kNever_s &&
           std::abs(received_s - one.second.received_s) <= kOff_s;
  });
}

// The clock of a camera's first packet.
CameraClocks::Clock CameraClocks::begun(std::uint32_t camera, double capture_s,
                                        double received_s) const {
  Clock clock;
  clock.start_s = clocks_.empty() ? capture_s : clocks_.begin()->second.start_s;
  clock.capture_s = kNever_s;
  const auto other = reference(camera, received_s);
  if (other == clocks_.end()) return clock;
  clock.start_s = other->second.start_s;
  const double apart_s = ahead_s(clock, other->second, capture_s, received_s);
  if (std::abs(apart_s) > kSameClock_s) clock.start_s += apart_s;
  return clock;
}

// Counts a packet that does not fit what is known of its clock. Returns whether that many in a row
// agree with each other.
bool CameraClocks::is_established(Clock& clock, double capture_s, int strays) {
  const bool follows = clock.strays > 0 && std::abs(capture_s - clock.stray_capture_s) < kLeap_s;
  clock.strays = follows ? clock.strays + 1 : 1;
  clock.stray_capture_s = capture_s;
  return clock.strays >= strays;
}

void CameraClocks::restart(std::uint32_t camera, Clock& clock, double capture_s, double received_s,
                           double after_s) {
  const auto other = reference(camera, received_s);
  double now_s = std::max(after_s, latest_s_) + kRestartPause_s;
  if (other != clocks_.end()) {
    now_s = other->second.capture_s - other->second.start_s + received_s - other->second.received_s;
  } else if (received_s <= kLongestGame_s) {
    now_s = std::max(now_s, received_s);
  }
  const double before_s = clock.start_s;
  clock = {};
  clock.start_s = capture_s - now_s;
  clock.capture_s = kNever_s;
  if (std::abs(clock.start_s - before_s) <= kLeap_s) return;
  restarts_ += now_s - restarted_s_ > kLeap_s ? 1 : 0;
  restarted_s_ = now_s;
}

// Compares the packet's clock with the reference's, and adjusts it if it is usually off by a
// little. Returns whether this packet is off by so much that it cannot be used.
bool CameraClocks::is_off(std::uint32_t camera, Clock& clock, double capture_s, double received_s) {
  const auto other = reference(camera, received_s);
  if (other == clocks_.end()) return false;
  const double apart_s = ahead_s(clock, other->second, capture_s, received_s);
  if (std::abs(apart_s) > kOff_s) return true;
  if (other->first > camera) return false;
  clock.ahead_s.push_back(apart_s);
  if (clock.ahead_s.size() < kCompared) return false;
  const double usual_s = median_of(clock.ahead_s);
  clock.ahead_s.clear();
  if (std::abs(usual_s) > kSameClock_s) clock.start_s += usual_s;
  return false;
}

// The packet's time, if it is newer than the camera's last one and the last frame.
std::optional<double> CameraClocks::newer_s(const Clock& clock, double capture_s, double after_s) {
  const double time_s = capture_s - clock.start_s;
  const bool is_newer = capture_s > clock.capture_s && time_s > after_s;
  return is_newer && time_s <= kLongestGame_s ? std::optional(time_s) : std::nullopt;
}

std::optional<double> CameraClocks::time_s(std::uint32_t camera, double capture_s,
                                           double received_s, double after_s) {
  if (!clocks_.contains(camera)) clocks_[camera] = begun(camera, capture_s, received_s);
  Clock& clock = clocks_.at(camera);
  const bool is_off_now = is_off(camera, clock, capture_s, received_s);
  std::optional<double> time_s = newer_s(clock, capture_s, after_s);
  if (is_off_now || !time_s) {
    const double step_s = capture_s - clock.start_s - latest_s_;
    if (!is_established(clock, capture_s, std::abs(step_s) > kLeap_s ? kLeaps : kStrays))
      return std::nullopt;
    restart(camera, clock, capture_s, received_s, after_s);
    time_s = newer_s(clock, capture_s, after_s);
    if (!time_s) return std::nullopt;
  }
  const double step_s = capture_s - clock.capture_s;
  if (step_s < kLongestInterval_s) {
    const bool is_gap = clock.interval_s > 0 && step_s > kGap * clock.interval_s;
    const double share = clock.interval_s == 0 ? 1 : is_gap ? kGapShare : kIntervalShare;
    clock.interval_s += share * (step_s - clock.interval_s);
  }
  clock.strays = 0;
  clock.capture_s = capture_s;
  clock.received_s = received_s;
  latest_s_ = std::max(latest_s_, *time_s);
  return time_s;
}

}  // namespace autoref::league
