#include "sim/presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

// The parameters measured or published for each simulator.
struct Model {
  const char* name = "";
  double slide_mps2 = 0;
  double roll_mps2 = 0;
  double roll_per_s = 0;
  double switch_ratio = 0;
  double first_xy = 0;
  double later_xy = 0;
  double first_z = 0;
  double later_z = 0;
};

constexpr double kStart_m = -14.0;

// The distance rolled to rest: the sum of v dv / (a + k v).
double rolled_m(double speed_mps, const Model& model) {
  constexpr int kSteps = 10000;
  const double dv = speed_mps / kSteps;
  double sum_m = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double v = (i + 0.5) * dv;
    sum_m += v * dv / (model.roll_mps2 + model.roll_per_s * v);
  }
  return sum_m;
}

class BallPreset : public testing::TestWithParam<Model> {
 protected:
  World world_with_ball(double speed_mps, double vertical_mps) const {
    Field field;
    field.length_m = 30.0;
    Configuration configuration = quiet();
    apply_ball_preset(GetParam().name, configuration.ball);
    World world(field, configuration, specs(1, 1), 1);
    BallState ball;
    ball.position_m = {kStart_m, 1.0};
    ball.velocity_mps = {speed_mps, 0.0};
    ball.vertical_mps = vertical_mps;
    ball.is_rolling = false;
    world.put_ball(ball);
    return world;
  }
};

// Lets the ball roll for 20 s. Returns its x when it began to roll.
double rolls_from_m(World& world) {
  double from_m = 0.0;
  for (int f = 0; f < 60 * 20; ++f) {
    world.step({}, {});
    const BallState& ball = world.state().ball;
    if (from_m == 0.0 && ball.is_rolling) from_m = ball.position_m.x();
  }
  return from_m;
}

TEST_P(BallPreset, SlidesAndRollsAsFarAsItsParametersImply) {
  const Model& model = GetParam();
  const double v = 4.0;
  const double rolls_at_mps = model.switch_ratio * v;
  const double slide_m = (v * v - rolls_at_mps * rolls_at_mps) / (2 * model.slide_mps2);
  const double roll_m = rolled_m(rolls_at_mps, model);
  World world = world_with_ball(v, 0.0);
  const double slid_m = rolls_from_m(world) - kStart_m;
  EXPECT_NEAR(slid_m, slide_m, 0.01 * slide_m + v / 60);  // observed once per frame
  EXPECT_NEAR(world.state().ball.position_m.x() - kStart_m, slide_m + roll_m, 0.01 * roll_m);
}

// The greatest height and the last speed along the ground of a ball's first three flights.
struct Hops {
  std::array<double, 3> peak_m{};
  std::array<double, 3> speed_mps{};
};

Hops first_hops(World& world) {
  Hops hops;
  double former_mps = world.state().ball.vertical_mps;
  for (std::size_t hop = 0; hop < 3;) {
    const BallState& ball = world.state().ball;
    hops.peak_m[hop] = std::max(hops.peak_m[hop], ball.height_m);
    hops.speed_mps[hop] = ball.velocity_mps.x();
    world.step({}, {});
    if (ball.vertical_mps > former_mps) ++hop;
    former_mps = ball.vertical_mps;
  }
  return hops;
}

TEST_P(BallPreset, BouncesByItsOwnFactors) {
  const Model& model = GetParam();
  World world = world_with_ball(2.0, 3.0);
  const auto [peak_m, speed_mps] = first_hops(world);
  EXPECT_NEAR(speed_mps[1], 2.0 * model.first_xy, 1e-3);
  EXPECT_NEAR(speed_mps[2], speed_mps[1] * model.later_xy, 1e-3);
  // In the frame nearest to its peak, the ball is at most g / 2 (1/120 s)^2 = 0.3 mm below the
  // peak.
  EXPECT_NEAR(std::sqrt(peak_m[1] / peak_m[0]), model.first_z, 0.01);
  EXPECT_NEAR(std::sqrt(peak_m[2] / peak_m[1]), model.later_z, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Models, BallPreset,
                         testing::Values(Model{.name = "default",
                                               .slide_mps2 = 3.4,
                                               .roll_mps2 = 0.30,
                                               .switch_ratio = 0.67,
                                               .first_xy = 0.75,
                                               .later_xy = 0.95,
                                               .first_z = 0.5,
                                               .later_z = 0.5},
                                         Model{.name = "erforce",
                                               .slide_mps2 = 3.92,
                                               .roll_mps2 = 0.35,
                                               .switch_ratio = 0.69,
                                               .first_xy = 0.715,
                                               .later_xy = 1.0,
                                               .first_z = 0.566,
                                               .later_z = 0.566},
                                         Model{.name = "tigers",
                                               .slide_mps2 = 3.0,
                                               .roll_mps2 = 0.26,
                                               .switch_ratio = 0.667,
                                               .first_xy = 0.8,
                                               .later_xy = 0.85,
                                               .first_z = 0.47,
                                               .later_z = 0.47},
                                         Model{.name = "grsim",
                                               .slide_mps2 = 10.3,
                                               .roll_mps2 = 0.70,
                                               .switch_ratio = 0.70,
                                               .first_xy = 0.59,
                                               .later_xy = 0.95,
                                               .first_z = 0.49,
                                               .later_z = 0.49},
                                         Model{.name = "rc2026",
                                               .slide_mps2 = 3.3,
                                               .roll_mps2 = 0.22,
                                               .roll_per_s = 0.045,
                                               .switch_ratio = 0.66,
                                               .first_xy = 0.70,
                                               .later_xy = 0.87,
                                               .first_z = 0.46,
                                               .later_z = 0.40}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BallPresets, DoNotChangeTheNet) {
  BallParameters ball;
  ball.net_mps2 = 7.0;
  apply_ball_preset("grsim", ball);
  EXPECT_EQ(ball.net_mps2, 7.0);
}

TEST(BallPresets, AreListedIfOneIsUnknown) {
  BallParameters ball;
  try {
    apply_ball_preset("tiger", ball);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("default, erforce, tigers, grsim, rc2026"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace autoref::sim
