#include "sim/world.hpp"

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "soccer/random.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

std::uint64_t hash_of(const WorldState& state) {
  std::uint64_t hash = 0;
  const auto add = [&hash](double value) {
    hash = mix_bits(hash ^ std::bit_cast<std::uint64_t>(value));
  };
  for (const auto& robots : state.robots.values) {
    for (const RobotState& robot : robots) {
      add(robot.position_m.x());
      add(robot.position_m.y());
      add(robot.heading.x());
      add(robot.velocity_mps.y());
    }
  }
  add(state.ball.position_m.x());
  add(state.ball.position_m.y());
  add(state.ball.height_m);
  return hash;
}

// Every robot runs for the ball and kicks it, and one robot per side chips. `side` considers only
// its own half and robots, so rotated worlds get rotated commands.
void chase(const WorldState& state, PerSide<TeamCommands>& commands) {
  for (const Side side : kSides) {
    for (const RobotState& robot : state.robots[side]) {
      const Vec2 to_ball = to_local(state.ball.position_m - robot.position_m, robot.heading);
      RobotCommand& command = commands[side][static_cast<std::size_t>(robot.number)];
      command.velocity_mps = clamp_norm(3.0 * to_ball, 2.0);
      command.angular_velocity_radps = 5.0 * angle_of(to_ball);
      command.kick_mps = robot.number < 4 ? 5.0 : 0.0;
      command.chip = robot.number == 1;
      command.dribble = robot.number == 5;
    }
  }
}

PerSide<TeamSpec> noisy_six() { return specs(6, 6, RobotSpec{}); }

std::uint64_t play_hash(std::uint64_t seed, const PerSide<TeamSpec>& teams, int frames) {
  World world(Field{}, quiet(), teams, seed);
  PerSide<TeamCommands> commands{};
  std::uint64_t hash = 0;
  for (int f = 0; f < frames; ++f) {
    chase(world.state(), commands);
    const bool is_stopped = f % 300 > 240;
    world.step(commands, is_stopped ? std::optional(Placement{{0, 0}, false}) : std::nullopt);
    hash = mix_bits(hash ^ hash_of(world.state()));
  }
  return hash;
}

TEST(World, IsReproducibleWithTheSameSeedAndCommands) {
  EXPECT_EQ(play_hash(1, noisy_six(), 1200), play_hash(1, noisy_six(), 1200));
}

TEST(World, DiffersWithAnotherSeed) {
  EXPECT_NE(play_hash(1, noisy_six(), 300), play_hash(2, noisy_six(), 300));
}

TEST(World, DoesNotDependOnTheSeedWithoutNoise) {
  EXPECT_EQ(play_hash(1, specs(6, 6), 300), play_hash(2, specs(6, 6), 300));
}

TEST(World, IsEquivariantUnderRotationBy180Degrees) {
  World world(Field{}, quiet(), specs(6, 6), 1);
  World turned(Field{}, quiet(), specs(6, 6), 1);
  BallState ball;
  ball.position_m = {0.4, -0.3};
  ball.velocity_mps = {-1.0, 0.5};
  world.put_ball(ball);
  ball.position_m = -ball.position_m;
  ball.velocity_mps = -ball.velocity_mps;
  turned.put_ball(ball);
  PerSide<TeamCommands> commands{};
  PerSide<TeamCommands> turned_commands{};
  for (int f = 0; f < 45; ++f) {
    chase(world.state(), commands);
    chase(turned.state(), turned_commands);
    world.step(commands, {});
    turned.step(turned_commands, {});
    const auto& now = world.state();
    const auto& then = turned.state();
    ASSERT_LT((now.ball.position_m + then.ball.position_m).norm(), 1e-6) << f;
    for (const Side side : kSides) {
      for (std::size_t n = 0; n < 6; ++n) {
        const Vec2& there = then.robots[opponent_of(side)][n].position_m;
        ASSERT_LT((now.robots[side][n].position_m + there).norm(), 1e-6) << f;
      }
    }
  }
}

TEST(World, StaysFiniteAndInsideItsWallsInACrowd) {
  World world(Field{}, Configuration{}, specs(16, 16, RobotSpec{}), 3);
  PerSide<TeamCommands> commands{};
  const Field field;
  for (int f = 0; f < 1800; ++f) {
    chase(world.state(), commands);
    world.step(commands, {});
    ASSERT_TRUE(world.is_finite());
    ASSERT_LT(std::abs(world.state().ball.position_m.x()), field.wall_x_m());
    ASSERT_LT(std::abs(world.state().ball.position_m.y()), field.wall_y_m());
  }
}

TEST(World, DetectsNonFiniteValues) {
  Scene scene;
  EXPECT_TRUE(scene.world.is_finite());
  scene.put_ball({0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0});
  EXPECT_FALSE(scene.world.is_finite());
}

TEST(LineUp, IsInTheOwnHalfAndRotatedForTheOtherSide) {
  World world(Field{}, Configuration{}, specs(16, 16), 1);
  const WorldState& state = world.state();
  for (std::size_t n = 0; n < 16; ++n) {
    const RobotState& west = state.robots[Side::kWest][n];
    EXPECT_LT(west.position_m.x(), -kRobotRadius_m);
    EXPECT_TRUE(is_on_field(Field{}, west.position_m));
    EXPECT_NEAR(west.heading.x(), 1.0, 1e-6);
    EXPECT_LT((west.position_m + state.robots[Side::kEast][n].position_m).norm(), 1e-6);
    for (std::size_t m = 0; m < n; ++m) {
      EXPECT_GT((west.position_m - state.robots[Side::kWest][m].position_m).norm(), 0.19);
    }
  }
}

TEST(LineUp, HasTheBallAtTheCentre) {
  Scene scene;
  EXPECT_EQ(scene.ball().position_m, Vec2(0, 0));
  EXPECT_EQ(scene.world.state().frame, 0);
}

TEST(Latency, IsFiveFramesByDefault) {
  const LatencySplit split = split_latency(Configuration{});
  EXPECT_EQ(split.frames, 5);
  EXPECT_EQ(split.substeps, 0);
}

TEST(Latency, OfFortyMillisecondsIsTwoFramesAndTwoSubsteps) {
  Configuration configuration;
  configuration.latency_s = 40_ms;
  const LatencySplit split = split_latency(configuration);
  EXPECT_EQ(split.frames, 2);
  EXPECT_EQ(split.substeps, 2);
}

TEST(Latency, KeepsTheFormerCommandsForTheRemainingSubsteps) {
  Configuration late = quiet();
  late.latency_s = 40_ms;
  Scene scene(late);
  scene.put_robot(kWest0, {-2, 0});
  scene.command(kWest0).velocity_mps = {3, 0};
  scene.frame();  // the last two of four sub-steps at 3 m/s^2
  EXPECT_NEAR(scene.robot(kWest0).velocity_mps.x(), 3.0 * 2 / 240, 1e-4);
}

// The longest time that Box2D measured for one of 100 steps.
float longest_step_ms(b2World& world) {
  float longest_ms = 0.0F;
  for (int i = 0; i < 100; ++i) {
    world.Step(1.0F / 60.0F, 8, 3);
    longest_ms = std::max(longest_ms, world.GetProfile().step);
  }
  return longest_ms;
}

TEST(Box2dClock, StandsStill) {
  // Box2D profiles each step; with its original clock, 100 steps would take measurable time.
  b2World world(b2Vec2(0.0F, -10.0F));
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  world.CreateBody(&definition);
  Scene scene;  // makes the linker include the bridge, and with it the replacement clock
  EXPECT_EQ(longest_step_ms(world), 0.0F);
}

struct Refused {
  const char* name;
  void (*spoil)(Configuration& configuration, PerSide<TeamSpec>& teams);
};

class WrongConfiguration : public testing::TestWithParam<Refused> {};

TEST_P(WrongConfiguration, IsRefusedByName) {
  Configuration configuration;
  PerSide<TeamSpec> teams = noisy_six();
  GetParam().spoil(configuration, teams);
  try {
    const World world(Field{}, configuration, teams, 1);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().name), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Fields, WrongConfiguration,
    testing::Values(
        Refused{"substeps", [](Configuration& c, PerSide<TeamSpec>&) { c.substeps = 0; }},
        Refused{"substeps", [](Configuration& c, PerSide<TeamSpec>&) { c.substeps = 17; }},
        Refused{"contact_free_substeps",
                [](Configuration& c, PerSide<TeamSpec>&) { c.contact_free_substeps = 0; }},
        Refused{"west robot 0: speed_factor",
                [](Configuration&, PerSide<TeamSpec>& s) {
                  s[Side::kWest].robots[0].speed_factor = -1;
                }},
        Refused{"east robot 5: acceleration_factor",
                [](Configuration&, PerSide<TeamSpec>& s) {
                  s[Side::kEast].robots[5].acceleration_factor = 2.1;
                }},
        Refused{"west robot 3: kicker.reach_m",
                [](Configuration&, PerSide<TeamSpec>& s) {
                  s[Side::kWest].robots[3].kicker.reach_m = -1;
                }},
        Refused{"east robot 1: dribbler.force_n",
                [](Configuration&, PerSide<TeamSpec>& s) {
                  s[Side::kEast].robots[1].dribbler.force_n = -1;
                }},
        Refused{"latency_s", [](Configuration& c, PerSide<TeamSpec>&) { c.latency_s = 0.6; }},
        Refused{"east robot 2: robot.mass_kg",
                [](Configuration&, PerSide<TeamSpec>& s) {
                  s[Side::kEast].robots[2].body.mass_kg = NAN;
                }},
        Refused{"east robot 2: robot.mass_kg",
                [](Configuration&, PerSide<TeamSpec>& s) {
                  s[Side::kEast].robots[2].body.mass_kg = 1e-50;  // 0 as a float
                }},
        Refused{"ball.slide_mps2",
                [](Configuration& c, PerSide<TeamSpec>&) { c.ball.slide_mps2 = 0; }}));

TEST(ConfigurationError, StatesTheValueAndTheRange) {
  try {
    Configuration configuration;
    configuration.substeps = 17;
    validate(configuration);
    FAIL() << "accepted";
  } catch (const OutOfRange& error) {
    EXPECT_STREQ(error.what(), "substeps is 17; it must be from 1 to 16");
    EXPECT_EQ(error.path(), "substeps");
  }
}

}  // namespace
}  // namespace autoref::sim
