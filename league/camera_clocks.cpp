#include "league/camera_clocks.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::league {
namespace {

// A camera heard within this time can be a reference. If a packet's clock is farther off than this,
// the packet was delayed or the clock was set.
constexpr double kOff_s = 0.1;
constexpr double kShortly_s = 0.02;         // packets that arrive within this time of each other
constexpr double kLeap_s = 1;               // larger steps of a clock count as restarts
constexpr double kImpossibleLeap_s = 1000;  // a larger leap is never real, whatever the pace
constexpr int kLeaps = 5;    // number of packets in a row that establish a restarted clock
constexpr int kStrays = 20;  // number of packets in a row that establish a clock that is off
constexpr int kStraysOfAnyPace = 250;
constexpr std::size_t kCompared = 31;  // number of packets; they take about half a second
constexpr int kEstablished = 31;
constexpr double kLongestInterval_s = 0.1;
// Shortest pause in the frames' times when a clock restarts, so that nothing seems to have moved
// instantly.
constexpr double kRestartPause_s = 0.2;
// The weight of a packet's interval in the usual interval. In a longer interval, packets may be
// missing.
constexpr double kIntervalShare = 0.125;
constexpr double kGapShare = 0.01;
constexpr double kGap = 1.5;  // as a multiple of the usual interval
constexpr double kPaceOver_s = 1;
constexpr double kPaceTolerance = 0.1;
// Given as a fraction of the time between the first and the last stray packet.
constexpr double kStrayTolerance = 0.25;
constexpr double kStrayTolerance_s = 0.02;

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

bool CameraClocks::has_room_for(std::uint32_t camera) const {
  return clocks_.size() < kMaxCameras || clocks_.contains(camera);
}

std::optional<double> CameraClocks::start_capture_s() const {
  return epoch_ ? std::optional(clocks_.at(*epoch_).start_s) : std::nullopt;
}

std::map<std::uint32_t, double> CameraClocks::ahead_s() const {
  std::map<std::uint32_t, double> ahead_s;
  for (const auto& [camera, clock] : clocks_) {
    const double apart_s = clock.start_s - start_capture_s().value_or(clock.start_s);
    if (clock.used >= kEstablished && std::abs(apart_s) > kSameClock_s) ahead_s[camera] = apart_s;
  }
  return ahead_s;
}

bool CameraClocks::is_heard(const Clock& clock, double received_s) {
  return clock.last && std::abs(received_s - clock.last->received_s) <= kOff_s;
}

// How far `clock` is ahead of another camera's clock, beyond the known difference.
double CameraClocks::ahead_s(const Clock& clock, const Clock& other, const Heard& heard) {
  const double between_captures_s =
      (heard.capture_s - clock.start_s) - (other.last->capture_s - other.start_s);
  return between_captures_s - (heard.received_s - other.last->received_s);
}

CameraClocks::Clocks::const_iterator CameraClocks::reference(std::uint32_t camera,
                                                             double received_s) const {
  return std::find_if(clocks_.begin(), clocks_.end(), [&](const auto& one) {
    return one.first != camera && is_heard(one.second, received_s);
  });
}

// The median over the other cameras that are heard and keep pace; if `counts_unknown`, also over
// those for which this is unknown. nullopt if there are no such cameras.
std::optional<double> CameraClocks::ahead_of_others_s(std::uint32_t camera, const Heard& heard,
                                                      bool counts_unknown) const {
  const Clock& clock = clocks_.at(camera);
  std::vector<double> all_s;
  for (const auto& [number, other] : clocks_) {
    if (number != camera && is_heard(other, heard.received_s) &&
        other.keeps_pace.value_or(counts_unknown))
      all_s.push_back(ahead_s(clock, other, heard));
  }
  return all_s.empty() ? std::nullopt : std::optional(median_of(all_s));
}

CameraClocks::Clock CameraClocks::first_clock(std::uint32_t camera, const Heard& heard) const {
  Clock clock;
  clock.start_s = start_capture_s().value_or(heard.capture_s);
  const auto other = reference(camera, heard.received_s);
  if (other == clocks_.end()) return clock;
  clock.start_s = other->second.start_s;
  const double apart_s = ahead_s(clock, other->second, heard);
  // A difference that is not large may be due to slow motion, in which little time passes between
  // captures and much between arrivals.
  const double between_arrivals_s = std::abs(heard.received_s - other->second.last->received_s);
  const bool is_plain = between_arrivals_s <= kShortly_s || std::abs(apart_s) > 2 * kOff_s;
  if (std::abs(apart_s) > kSameClock_s && is_plain && other->second.keeps_pace.value_or(true))
    clock.start_s += apart_s;
  return clock;
}

// Whether the clock is off by so much that the packet cannot be used.
bool CameraClocks::is_off(std::uint32_t camera, const Heard& heard) const {
  if (const auto apart_s = ahead_of_others_s(camera, heard, false))
    return std::abs(*apart_s) > kOff_s;
  const Clock& clock = clocks_.at(camera);
  if (!clock.last) return false;
  const double leap_s = ahead_s(clock, clock, heard);
  return leap_s > (clock.keeps_pace.value_or(true) ? kLeap_s : kImpossibleLeap_s);
}

// Compares the clock with the reference, and adjusts it if it is usually off by a little.
void CameraClocks::compare(std::uint32_t camera, const Heard& heard) {
  const auto other = reference(camera, heard.received_s);
  if (other == clocks_.end() || other->first > camera) return;
  Clock& clock = clocks_.at(camera);
  clock.ahead_s.push_back(ahead_s(clock, other->second, heard));
  if (clock.ahead_s.size() < kCompared) return;
  const double usual_s = median_of(clock.ahead_s);
  clock.ahead_s.clear();
  if (std::abs(usual_s) > kSameClock_s && other->second.keeps_pace.value_or(false))
    clock.start_s += usual_s;
}

std::optional<double> CameraClocks::time_if_newer_s(const Clock& clock, double capture_s,
                                                    double after_s) {
  const double time_s = capture_s - clock.start_s;
  const bool is_newer =
      (!clock.last || capture_s > clock.last->capture_s) && time_s > after_s - kOld_s;
  return is_newer && time_s <= kLongestGame_s ? std::optional(time_s) : std::nullopt;
}

// Counts a packet that cannot be used. Returns whether so many packets in a row agree with each
// other that their clock is now the camera's clock.
bool CameraClocks::has_changed(Clock& clock, const Heard& heard) const {
  const bool follows =
      clock.strays > 0 && std::abs(heard.capture_s - clock.last_stray.capture_s) < kLeap_s;
  clock.strays = follows ? clock.strays + 1 : 1;
  if (!follows) clock.first_stray = heard;
  clock.last_stray = heard;
  const double captured_s = heard.capture_s - clock.first_stray.capture_s;
  const double arrived_s = heard.received_s - clock.first_stray.received_s;
  const bool keeps_pace =
      std::abs(captured_s - arrived_s) <= kStrayTolerance_s + kStrayTolerance * captured_s;
  const bool is_leap = std::abs(heard.capture_s - clock.start_s - latest_s_) > kLeap_s;
  return keeps_pace ? clock.strays >= (is_leap ? kLeaps : kStrays)
                    : clock.strays >= kStraysOfAnyPace;
}

// The clock continues at the time of the other cameras or, if there are none, at the time of
// arrival.
void CameraClocks::restart(std::uint32_t camera, const Heard& heard, double after_s) {
  Clock& clock = clocks_.at(camera);
  const double before_s = clock.start_s;
  if (const auto apart_s = ahead_of_others_s(camera, heard, true)) {
    clock.start_s += *apart_s;
  } else {
    const double earliest_s = std::max(after_s, latest_s_) + kRestartPause_s;
    clock.start_s =
        heard.capture_s -
        (heard.received_s <= kLongestGame_s ? std::max(earliest_s, heard.received_s) : earliest_s);
  }
  clock.last.reset();
  clock.before.reset();
  clock.ahead_s.clear();
  if (std::abs(clock.start_s - before_s) <= kLeap_s) return;
  const double now_s = heard.capture_s - clock.start_s;
  restarts_ += now_s - restarted_s_ > kLeap_s ? 1 : 0;
  restarted_s_ = now_s;
}

void CameraClocks::use(std::uint32_t camera, const Heard& heard) {
  Clock& clock = clocks_.at(camera);
  if (!epoch_ || (clocks_.at(*epoch_).used < kEstablished && clock.used + 1 >= kEstablished))
    epoch_ = camera;
  const double step_s = clock.last ? heard.capture_s - clock.last->capture_s : kLongestInterval_s;
  if (step_s < kLongestInterval_s) {
    const bool is_gap = clock.interval_s > 0 && step_s > kGap * clock.interval_s;
    const double share = clock.interval_s == 0 ? 1 : is_gap ? kGapShare : kIntervalShare;
    clock.interval_s += share * (step_s - clock.interval_s);
  }
  if (!clock.before) clock.before = heard;
  const double captured_s = heard.capture_s - clock.before->capture_s;
  const double arrived_s = heard.received_s - clock.before->received_s;
  if (std::max(captured_s, std::abs(arrived_s)) >= kPaceOver_s) {
    clock.keeps_pace = std::abs(captured_s - arrived_s) <= kPaceTolerance * captured_s;
    clock.before = heard;
  }
  clock.last = heard;
  clock.strays = 0;
  clock.used = std::min(clock.used + 1, kEstablished);
  latest_s_ = std::max(latest_s_, heard.capture_s - clock.start_s);
}

std::optional<double> CameraClocks::time_s(std::uint32_t camera, double capture_s,
                                           double received_s, double after_s) {
  const Heard heard{capture_s, received_s};
  if (!clocks_.contains(camera)) clocks_[camera] = first_clock(camera, heard);
  const bool is_off_now = is_off(camera, heard);
  if (!is_off_now) compare(camera, heard);
  Clock& clock = clocks_.at(camera);
  std::optional<double> time_s = time_if_newer_s(clock, capture_s, after_s);
  if (is_off_now || !time_s) {
    if (!has_changed(clock, heard)) return std::nullopt;
    restart(camera, heard, after_s);
    time_s = time_if_newer_s(clock, capture_s, after_s);
    if (!time_s) return std::nullopt;
  }
  use(camera, heard);
  return time_s;
}

}  // namespace autoref::league
