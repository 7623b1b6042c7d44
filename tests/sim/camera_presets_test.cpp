#include "sim/presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "soccer/trigonometry.hpp"
#include "tests/sim/camera_scene.hpp"

namespace autoref::sim {
namespace {

TEST(CameraPreset, IsRefusedIfUnknownAndTheKnownAreListed) {
  Configuration configuration;
  try {
    apply_camera_preset("sharp", configuration);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what())
                  .find("known: paper, none, friendly, rc2021, realistic, "
                        "rc2026-b, rc2026-a"),
              std::string::npos)
        << error.what();
  }
}

// Statistics of a preset's frames of a robot and a ball at rest.
struct Observed {
  double ball_m2 = 0;  // mean squared error of a coordinate
  double robot_m2 = 0;
  double robot_rad2 = 0;
  double ball_misses = 0;
  double robot_misses = 0;
};

// Without systematic errors, false detections and longer gaps.
Camera unbiased_camera_of(const char* preset) {
  Configuration configuration;
  apply_camera_preset(preset, configuration);
  VisionParameters& vision = configuration.vision;
  vision.camera_error_m = vision.camera_error_rad = 0;
  vision.false_balls_per_s = vision.misread_numbers = vision.robot_gaps = 0;
  return {vision, Field{}, configuration.frame_rate_hz, 1};
}

Observed observe(const char* preset, int frames) {
  Camera camera = unbiased_camera_of(preset);
  const WorldState world = world_with_robot_at({1, 1}, {-1, 0.5});
  Frame frame;
  Observed sum;
  int balls = 0;
  int robots = 0;
  for (int i = 0; i < frames; ++i) {
    camera.look(world, frame);
    if (frame.ball) {
      ++balls;
      sum.ball_m2 += (frame.ball->position_m - world.ball.position_m).squaredNorm() / 2;
    }
    for (const RobotObservation& robot : frame.robots[Side::kEast]) {
      ++robots;
      sum.robot_m2 += (robot.position_m - Vec2(1, 1)).squaredNorm() / 2;
      sum.robot_rad2 += std::pow(angle_of(robot.heading), 2);
    }
  }
  return {sum.ball_m2 / balls, sum.robot_m2 / robots, sum.robot_rad2 / robots,
          1.0 - static_cast<double>(balls) / frames, 1.0 - static_cast<double>(robots) / frames};
}

struct Kind {
  const char* name = "";
  double ball_m = 0;
  double robot_m = 0;
  double robot_rad = 0;
  double ball_misses = 0;
  double robot_misses = 0;
  double command_loss = 0;
  double latency_s = 0;
  double frame_rate_hz = 60;
};

class CameraKind : public testing::TestWithParam<Kind> {};

TEST_P(CameraKind, HasTheNoiseAndTheMissRatesOfTheTable) {
  constexpr int kFrames = 40000;
  const Kind& kind = GetParam();
  const Observed seen = observe(kind.name, kFrames);
  // Tolerances are five standard deviations of the estimated variance (40000 frames, two
  // coordinates each) and of the estimated proportion.
  EXPECT_NEAR(std::sqrt(seen.ball_m2), kind.ball_m, 0.013 * kind.ball_m + 1e-7);
  EXPECT_NEAR(std::sqrt(seen.robot_m2), kind.robot_m, 0.013 * kind.robot_m + 1e-7);
  EXPECT_NEAR(std::sqrt(seen.robot_rad2), kind.robot_rad, 0.018 * kind.robot_rad + 1e-7);
  const auto tolerance = [](double share) { return 5 * std::sqrt(share * (1 - share) / kFrames); };
  EXPECT_NEAR(seen.ball_misses, kind.ball_misses, tolerance(kind.ball_misses));
  EXPECT_NEAR(seen.robot_misses, kind.robot_misses, tolerance(kind.robot_misses));
}

TEST_P(CameraKind, SetsRadioAndLatencyAndIsIdentifiedByItsParameters) {
  const Kind& kind = GetParam();
  Configuration configuration;
  apply_camera_preset(kind.name, configuration);
  EXPECT_EQ(configuration.radio.command_loss, kind.command_loss);
  EXPECT_DOUBLE_EQ(configuration.latency_s, kind.latency_s);
  EXPECT_EQ(configuration.frame_rate_hz, kind.frame_rate_hz);
  EXPECT_EQ(camera_preset_of(configuration), kind.name);
  configuration.vision.ball_misses += 0.01;
  EXPECT_EQ(camera_preset_of(configuration), std::nullopt);
}

// The realism levels of ER-Force's simulator, and the vision measured in 2026.
INSTANTIATE_TEST_SUITE_P(Presets, CameraKind,
                         testing::Values(Kind{.name = "paper", .latency_s = 5 / 60.0},
                                         Kind{.name = "none", .latency_s = 5 / 60.0},
                                         Kind{.name = "friendly",
                                              .ball_m = 0.0004,
                                              .robot_m = 0.0003,
                                              .robot_rad = 0.003,
                                              .ball_misses = 0.05,
                                              .robot_misses = 0.02,
                                              .command_loss = 0.01,
                                              .latency_s = 0.045},
                                         Kind{.name = "rc2021",
                                              .ball_m = 0.001,
                                              .robot_m = 0.0013,
                                              .robot_rad = 0.01,
                                              .ball_misses = 0.05,
                                              .command_loss = 0.03,
                                              .latency_s = 0.045},
                                         Kind{.name = "realistic",
                                              .ball_m = 0.0014,
                                              .robot_m = 0.0013,
                                              .robot_rad = 0.01,
                                              .ball_misses = 0.05,
                                              .robot_misses = 0.02,
                                              .command_loss = 0.03,
                                              .latency_s = 0.048},
                                         Kind{.name = "rc2026-b",
                                              .ball_m = 0.0007,
                                              .robot_m = 0.0005,
                                              .robot_rad = 0.005,
                                              .ball_misses = 0.007,
                                              .robot_misses = 0.007,
                                              .command_loss = 0.03,
                                              .latency_s = 0.0323,
                                              .frame_rate_hz = 73.2},
                                         Kind{.name = "rc2026-a",
                                              .ball_m = 0.0007,
                                              .robot_m = 0.0005,
                                              .robot_rad = 0.005,
                                              .ball_misses = 0.007,
                                              .robot_misses = 0.007,
                                              .command_loss = 0.03,
                                              .latency_s = 0.0323,
                                              .frame_rate_hz = 73.2}),
                         [](const auto& kind) {
                           std::string name = kind.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace autoref::sim
