// The tracker's estimates for chips and straight kicks of simulated robots, seen by simulated
// cameras that report no heights.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/camera.hpp"
#include "sim/presets.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"
#include "tests/sim/scene.hpp"
#include "tracking/tracker.hpp"

namespace autoref::sim {
namespace {

// Sums over the frames of first flights from 150 ms after the kick, while the ball is higher than
// 50 mm.
struct Heights {
  int frames = 0;
  int detected = 0;  // as flying
  double error2_m2 = 0;
  double position_error2_m2 = 0;
  int honest = 0;  // error within two estimated deviations
  int wrong = 0;   // reported in the air while on the carpet

  double rms_m() const { return std::sqrt(error2_m2 / detected); }
  double position_rms_m() const { return std::sqrt(position_error2_m2 / detected); }
};

void watch(const WorldState& world, const TrackedBall& ball, double since_kick_s, bool has_landed,
           Heights& sums) {
  const bool flies = world.ball.height_m > 0.05 && !has_landed;
  if (!flies && world.ball.height_m <= 0.0 && ball.height_m > 0.0) ++sums.wrong;
  if (!flies || since_kick_s < 0.15) return;
  ++sums.frames;
  if (ball.height_m <= 0.0) return;
  ++sums.detected;
  const double error_m = ball.height_m - world.ball.height_m;
  sums.error2_m2 += error_m * error_m;
  sums.position_error2_m2 += (ball.position_m - world.ball.position_m).squaredNorm();
  sums.honest += std::abs(error_m) <= 2 * ball.height_deviation_m ? 1 : 0;
}

// One robot kicks from a random position, in a random direction across the field.
void kick_and_watch(RandomStream& random, std::uint64_t seed, bool chip, Heights& sums) {
  Configuration configuration = quiet();
  apply_camera_preset("realistic", configuration);
  configuration.radio.command_loss = 0.0;
  configuration.latency_s = 0.05 * random.uniform();  // kicks occur anywhere between two frames
  Scene scene(configuration, specs(1, 0), seed);
  Camera camera(configuration.vision, scene.field, 60, seed);
  tracking::Tracker tracker({configuration.vision.ball_noise_m, configuration.vision.robot_noise_m,
                             configuration.vision.robot_noise_rad});
  const double x_m = 4 * (random.uniform() - 0.5);
  const double y_m = 3 * (random.uniform() - 0.5);
  const double heading_rad = 2 * kPi * random.uniform();
  const double speed_mps = 3.0 + 2.5 * random.uniform();
  scene.put_robot(kWest0, {x_m, y_m}, heading_of(heading_rad));
  scene.put_ball_at_plate(kWest0, 0.002);
  Frame frame;
  double kicked_s = 1e9;
  double former_rise_mps = 100;
  bool has_landed = false;
  for (int f = 0; f < 75; ++f) {
    scene.command(kWest0).kick_mps = f >= 30 ? speed_mps : 0.0;
    scene.command(kWest0).chip = chip;
    scene.frame();
    camera.look(scene.world.state(), frame);
    const Tracks& tracks = tracker.update(frame);
    if (!scene.world.touches().empty()) kicked_s = std::min(kicked_s, frame.time_s);
    // The vertical speed only decreases during the flight.
    const double rise_mps = scene.ball().vertical_mps;
    has_landed = has_landed || (frame.time_s > kicked_s && rise_mps > former_rise_mps);
    former_rise_mps = rise_mps;
    if (!tracks.ball) continue;
    watch(scene.world.state(), *tracks.ball, frame.time_s - kicked_s, has_landed, sums);
  }
}

Heights heights_of_kicks(int kicks, std::uint64_t seed, bool chip) {
  RandomStream random(seed);
  Heights sums;
  for (int i = 0; i < kicks; ++i) {
    kick_and_watch(random, static_cast<std::uint64_t>(i), chip, sums);
  }
  return sums;
}

TEST(ChipSeen, IsReportedWithItsHeightUnderRealisticVision) {
  const Heights sums = heights_of_kicks(300, 3, true);
  ASSERT_GT(sums.frames, 3000);
  EXPECT_GE(sums.detected, 0.90 * sums.frames) << sums.detected << " of " << sums.frames;
  EXPECT_LT(sums.rms_m(), 0.06);
  EXPECT_LT(sums.position_rms_m(), 0.06);
  // Measured: 93 % instead of the nominal 95 %; kicks late between two frames are detected late.
  EXPECT_GE(sums.honest, 0.91 * sums.detected) << sums.honest << " of " << sums.detected;
}

TEST(ChipSeen, IsRarelyReportedForAStraightKick) {
  const Heights sums = heights_of_kicks(300, 4, false);
  EXPECT_EQ(sums.frames, 0);
  // Measured: 35 of some 13500 frames after the kick.
  EXPECT_LE(sums.wrong, 0.004 * 300 * 45) << "frames with the ball reported in the air";
}

}  // namespace
}  // namespace autoref::sim
