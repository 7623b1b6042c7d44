#include "live/frame_pacer.hpp"

#include <gtest/gtest.h>

namespace autoref::live {
namespace {

using std::chrono::milliseconds;

// A clock that moves only when somebody sleeps or says so.
class ManualClock final : public FrameClock {
 public:
  Time now() const override { return time; }
  void sleep_until(Time until) override { time = until; }
  Time time{};
};

TEST(FramePacer, FramesAreDueAtEqualDistances) {
  ManualClock clock;
  FramePacer pacer(clock, 50);
  for (int i = 0; i < 10; ++i) pacer.wait();
  EXPECT_EQ(clock.time - ManualClock::Time{}, milliseconds(200));
  EXPECT_EQ(pacer.punctuality().frames, 10);
  EXPECT_EQ(pacer.punctuality().late, 0);
}

TEST(FramePacer, AShortDelayIsCaughtUp) {
  ManualClock clock;
  FramePacer pacer(clock, 50);
  pacer.wait();
  clock.time += milliseconds(45);
  pacer.wait();
  pacer.wait();
  pacer.wait();
  EXPECT_EQ(clock.time - ManualClock::Time{}, milliseconds(80));
  EXPECT_EQ(pacer.punctuality().late, 2);  // due at 40 and 60 ms, begun at 65 ms
  EXPECT_DOUBLE_EQ(pacer.punctuality().worst_ms, 25);
}

TEST(FramePacer, AfterALongDelayTheScheduleBeginsAnew) {
  ManualClock clock;
  FramePacer pacer(clock, 50);
  clock.time += milliseconds(5000);
  pacer.wait();
  const auto resumed = clock.time;
  pacer.wait();
  EXPECT_EQ(clock.time - resumed, milliseconds(20));
  EXPECT_EQ(pacer.punctuality().restarts, 1);
}

TEST(FramePacer, AnotherRateHoldsFromTheNextFrameOn) {
  ManualClock clock;
  FramePacer pacer(clock, 50);
  pacer.wait();
  pacer.set_rate(200);
  pacer.wait();
  EXPECT_EQ(clock.time - ManualClock::Time{}, milliseconds(25));
}

TEST(FramePacer, AnotherRateWhileAFrameIsAwaitedHoldsAtOnce) {
  ManualClock clock;
  FramePacer pacer(clock, 0.1);
  int looks = 0;
  pacer.wait([&] {
    if (++looks == 4) pacer.set_rate(50);
  });
  EXPECT_EQ(clock.time - ManualClock::Time{}, milliseconds(200));
  pacer.wait();
  EXPECT_EQ(clock.time - ManualClock::Time{}, milliseconds(220));
}

}  // namespace
}  // namespace autoref::live
