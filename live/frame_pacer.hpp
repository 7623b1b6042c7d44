// Paces a game by the clock, in a thread that the system wakes promptly although others compute.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>

namespace autoref::live {

// How punctual a loop was.
struct Punctuality {
  std::int64_t frames = 0;
  std::int64_t late = 0;  // frames that began more than kLate after their time
  double worst_ms = 0;
  std::int64_t restarts = 0;  // of the schedule, after long delays
};

inline constexpr std::chrono::milliseconds kLate{2};

// A clock that can sleep; tests use one of their own.
class FrameClock {
 public:
  using Time = std::chrono::steady_clock::time_point;
  virtual ~FrameClock() = default;
  virtual Time now() const = 0;
  virtual void sleep_until(Time time) = 0;
};

// The system's clock.
class SteadyFrameClock final : public FrameClock {
 public:
  Time now() const override { return std::chrono::steady_clock::now(); }
  void sleep_until(Time time) override;
};

// Frames are due at equal distances. No frame is skipped: after a delay, the next frames follow at
// once until the schedule is met again, or, after more than a second, the schedule restarts.
class FramePacer {
 public:
  FramePacer(FrameClock& clock, double frames_per_s);

  // Other frames per second from now on; the next frame is due at once.
  void set_rate(double frames_per_s);

  // Sleeps until the next frame is due. Calls `meanwhile`, if any, at least every 50 ms; it may set
  // the rate.
  void wait(const std::function<void()>& meanwhile = {});

  const Punctuality& punctuality() const { return punctuality_; }

 private:
  FrameClock::Time due() const;

  FrameClock* clock_;
  std::chrono::duration<double> period_;
  FrameClock::Time start_;
  std::int64_t frames_ = 0;  // since `start_`
  Punctuality punctuality_;
};

// Asks the system to let the calling thread begin soon when it wakes, in exchange for shorter turns
// on the processor, and not to delay its timers. No privileges are needed. Systems that know
// nothing of it, such as Linux before 6.12, go on as before; so does a thread with a real-time
// policy. Threads and processes that the calling thread starts later inherit the short turns.
void be_prompt();

}  // namespace autoref::live
