#include "live/frame_pacer.hpp"

#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <algorithm>
#include <cstdint>
#include <ctime>

namespace autoref::live {
namespace {

constexpr std::chrono::seconds kLongestDelay{1};
constexpr std::chrono::milliseconds kLongestSleep{50};

constexpr std::uint64_t kTurn_ns = 100'000;  // the shortest time slice that Linux grants

// The kernel's struct sched_attr, redefined because its header conflicts with <sched.h>.
struct SchedulingAttributes {
  std::uint32_t size;
  std::uint32_t policy;
  std::uint64_t flags;
  std::int32_t nice;
  std::uint32_t priority;
  std::uint64_t runtime_ns;  // with the ordinary policy: length of a time slice
  std::uint64_t deadline_ns;
  std::uint64_t period_ns;
};

}  // namespace

// With an absolute time, an interrupted sleep continues without drift.
void SteadyFrameClock::sleep_until(Time time) {
  const auto since_epoch =
      std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
  const timespec until{static_cast<time_t>(since_epoch / 1'000'000'000),
                       static_cast<long>(since_epoch % 1'000'000'000)};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
}

FramePacer::FramePacer(FrameClock& clock, double frames_per_s)
    : clock_(&clock), period_(1 / frames_per_s), start_(clock.now()) {}

void FramePacer::set_rate(double frames_per_s) {
  period_ = std::chrono::duration<double>(1 / frames_per_s);
  start_ = clock_->now();
  frames_ = 0;
}

FrameClock::Time FramePacer::due() const {
  return start_ + std::chrono::duration_cast<FrameClock::Time::duration>(
                      period_ * static_cast<double>(frames_));
}

void FramePacer::wait(const std::function<void()>& meanwhile) {
  ++frames_;
  while (clock_->now() < due()) {
    clock_->sleep_until(std::min(due(), clock_->now() + kLongestSleep));
    if (meanwhile && clock_->now() < due()) meanwhile();
  }
  const auto delay = clock_->now() - due();
  ++punctuality_.frames;
  punctuality_.late += delay > kLate ? 1 : 0;
  punctuality_.worst_ms =
      std::max(punctuality_.worst_ms, std::chrono::duration<double, std::milli>(delay).count());
  if (delay <= kLongestDelay) return;
  ++punctuality_.restarts;
  start_ = clock_->now();
  frames_ = 0;
}

void be_prompt() {
  prctl(PR_SET_TIMERSLACK, 1, 0, 0, 0);
  SchedulingAttributes attributes{};
  if (syscall(SYS_sched_getattr, 0, &attributes, sizeof attributes, 0) != 0) return;
  if (attributes.policy != SCHED_OTHER) return;
  attributes.runtime_ns = kTurn_ns;
  syscall(SYS_sched_setattr, 0, &attributes, 0);
}

}  // namespace autoref::live
