// The effect of a lossy radio on commands.
#include <gtest/gtest.h>

#include <algorithm>

#include "soccer/random.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

Configuration lossy(double share) {
  Configuration configuration = quiet();
  configuration.radio.command_loss = share;
  return configuration;
}

// Commands alternate between opposite directions every frame. A lost command leaves the robot's
// acceleration as it was; losses are counted from the robot's speed.
double share_of_ignored_commands(double loss, int frames) {
  Scene scene(lossy(loss));
  scene.put_robot(kWest0, {-1, 0});
  int ignored = 0;
  double former_mps = 0.0;
  for (int f = 0; f < frames; ++f) {
    const bool forward = f % 2 == 0;
    scene.command(kWest0).velocity_mps = {forward ? 1.0 : -1.0, 0.0};
    scene.frame();
    const double speed_mps = scene.robot(kWest0).velocity_mps.x();
    ignored += (speed_mps > former_mps) == forward ? 0 : 1;
    former_mps = speed_mps;
  }
  return static_cast<double>(ignored) / frames;
}

TEST(Radio, LosesTheConfiguredShareOfCommands) {
  EXPECT_EQ(share_of_ignored_commands(0.0, 1200), 0.0);
  // Two consecutive losses repeat the command before last, which is the right one, so the fraction
  // of wrong commands is p - p^2 + p^3 - ... = p / (1 + p) = 0.2 / 1.2. The tolerance is five
  // standard deviations for 6000 commands.
  EXPECT_NEAR(share_of_ignored_commands(0.2, 6000), 0.2 / 1.2, 0.026);
}

// Nine of ten commands are lost. The test draws from the same random stream as the radio, so it
// knows which.
TEST(Radio, LetsARobotContinueForATenthOfASecondThenStopsIt) {
  constexpr double kLoss = 0.9;
  constexpr std::uint64_t kSeed = 1;
  constexpr double kFrame_s = 1.0 / 60.0;
  Scene scene(lossy(kLoss), specs(1, 1), kSeed);
  RandomStream radio = RandomStream::of(kSeed, RandomPurpose::kRadio, Side::kWest);
  scene.command(kWest0).velocity_mps = {1.0, 0.0};
  int silent_frames = 1000;  // no command received yet
  double expected_mps = 0.0;
  int gone_on = 0;
  int stopped = 0;
  for (int f = 0; f < 1200; ++f) {
    silent_frames = radio.uniform() < kLoss ? silent_frames + 1 : 0;
    const bool goes_on = silent_frames < 6;
    gone_on += goes_on && silent_frames > 0 ? 1 : 0;
    stopped += !goes_on && expected_mps > 0.5 ? 1 : 0;
    expected_mps = goes_on ? std::min(1.0, expected_mps + 3.0 * kFrame_s)
                           : std::max(0.0, expected_mps - 5.0 * kFrame_s);
    scene.put_robot(kWest0, {0, 0}, {1, 0}, scene.robot(kWest0).velocity_mps);
    scene.frame();
    // A speed slightly below zero is braked first, at 5 m/s2 for one sub-step.
    ASSERT_NEAR(scene.robot(kWest0).velocity_mps.x(), expected_mps, 0.0084) << f;
  }
  EXPECT_GT(gone_on, 100);
  EXPECT_GT(stopped, 20);
}

}  // namespace
}  // namespace autoref::sim
