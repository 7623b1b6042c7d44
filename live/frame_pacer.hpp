// Paces a game by the clock, in a thread that the system wakes promptly even under load.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>

namespace autoref::live {

// The punctuality of a loop.
struct Punctuality {
  std::int64_t frames = 0;
  std::int64_t late = 0;  // frames that began more than kLate after their time
  double worst_ms = 0;
  std::int64_t restarts = 0;  // restarts of the schedule after long delays
};

inline constexpr std::chrono::milliseconds kLate{2};

// A clock that can sleep; tests use their own.
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

// Frames are due at equal intervals. No frame is skipped: after a delay, the next frames follow
// immediately until the game is on schedule again. After a delay of more than a second, the
// schedule restarts.
class FramePacer {
 public:
  FramePacer(FrameClock& clock, double frames_per_s);

  // Changes the frame rate; the next frame is due immediately.
  void set_rate(double frames_per_s);

  // Sleeps until the next frame is due. Calls `meanwhile`, if given, at least every 50 ms;
  // `meanwhile` may change the rate.
  void wait(const std::function<void()>& meanwhile = {});

  const Punctuality& punctuality() const { return punctuality_; }

 private:
  FrameClock::Time due() const;

  FrameClock* clock_;
  std::chrono::duration<double> period_;
  FrameClock::Time start_;
  std::int64_t frames_ = 0;  // number of frames since `start_`
  Punctuality punctuality_;
};

// Asks the system to run the calling thread promptly when it wakes, in exchange for shorter time
// slices, and not to delay the thread's timers. No privileges are needed. This has no effect on
// systems that do not support it, such as Linux before 6.12, or on a thread with a real-time
// policy. Threads and processes that the calling thread starts later inherit the short slices.
void be_prompt();

}  // namespace autoref::live
