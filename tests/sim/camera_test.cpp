#include "sim/camera.hpp"

#include <gtest/gtest.h>

#include "soccer/random.hpp"

namespace autoref::sim {
namespace {

bool is_float_mm(double metres) {
  // volatile: the rounding must happen, whatever the compiler thinks of it.
  volatile float millimetres = static_cast<float>(metres * 1000.0);
  return static_cast<double>(millimetres) / 1000.0 == metres;
}

TEST(Camera, ReportsPositionsRoundedToFloatMillimetres) {
  const Camera camera(camera_preset("paper"), 60);
  RandomStream random(1);
  WorldState world;
  world.robots[Side::kEast].push_back({});
  Frame frame;
  for (int i = 0; i < 1000; ++i) {
    RobotState& robot = world.robots[Side::kEast][0];
    robot.position_m.x() = 6 * random.uniform() - 3;
    robot.position_m.y() = 4 * random.uniform() - 2;
    world.ball.position_m.x() = 6 * random.uniform() - 3;
    world.ball.position_m.y() = 4 * random.uniform() - 2;
    world.ball.height_m = random.uniform();
    camera.look(world, frame);
    const Vec2& seen_m = frame.robots[Side::kEast][0].position_m;
    ASSERT_TRUE(is_float_mm(seen_m.x()) && is_float_mm(seen_m.y())) << i;
    ASSERT_LT((seen_m - robot.position_m).norm(), 1e-6);
    ASSERT_TRUE(is_float_mm(frame.ball->position_m.x()) && is_float_mm(frame.ball->position_m.y()));
    ASSERT_TRUE(is_float_mm(*frame.ball->height_m));
  }
}

TEST(Camera, StampsFramesWithTheirNumberOverTheRate) {
  const Camera camera(camera_preset("paper"), 60);
  WorldState world;
  world.frame = 90;
  Frame frame;
  camera.look(world, frame);
  EXPECT_EQ(frame.number, 90);
  EXPECT_EQ(frame.time_s, 1.5);
}

TEST(Camera, RefusesAnUnknownPresetAndNamesTheKnown) {
  try {
    camera_preset("sharp");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("known: paper"), std::string::npos);
  }
}

}  // namespace
}  // namespace autoref::sim
