#include "live/simulator/robot_updates.hpp"

#include <gtest/gtest.h>

#include "benchmarks/beside_live_game.hpp"
#include "io/errors.hpp"
#include "league/messages/simulation.pb.h"
#include "live/simulator/live_game.hpp"
#include "tests/live/simulator/caller.hpp"
#include "tests/live/simulator/short_network_game.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::live {
namespace {

league::SpecUpdate update_of(RobotId robot) {
  league::SpecUpdate update;
  update.robot = robot;
  return update;
}

class RobotUpdatesTest : public testing::Test {
 protected:
  game::GameConfiguration game_;
  RobotUpdates updates_{game_};
  std::vector<league::PacketError> errors_;
};

TEST_F(RobotUpdatesTest, ChangeOnlyWhatIsSet) {
  league::SpecUpdate update = update_of({Side::kEast, 2});
  update.acceleration_mps2 = 6;
  update.kick_limit_mps = 6.5;
  updates_.add({update}, errors_);
  EXPECT_TRUE(errors_.empty());
  const std::vector<game::ChangedRobot> changed = updates_.close();
  ASSERT_EQ(changed.size(), 1U);
  game::apply(changed[0], game_);
  const sim::RobotSpec& robot = game::team_on(game_, Side::kEast).robots[2];
  EXPECT_EQ(robot.body.acceleration_mps2, 6);
  EXPECT_EQ(robot.body.wheel_acceleration_mps2, 9);  // twice 4.5, as 6 is twice 3
  EXPECT_EQ(robot.kicker.speed_limit_mps, 6.5);
  EXPECT_EQ(robot.body.mass_kg, 2.5);
  EXPECT_EQ(game::team_on(game_, Side::kWest).robots[2].kicker.speed_limit_mps, 8);
}

TEST_F(RobotUpdatesTest, AddUp) {
  league::SpecUpdate update = update_of({Side::kWest, 0});
  update.mass_kg = 2;
  updates_.add({update}, errors_);
  update.mass_kg.reset();
  update.speed_mps = 1.5;
  updates_.add({update}, errors_);
  const std::vector<game::ChangedRobot> changed = updates_.close();
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(changed[0].mass_kg, 2);
  EXPECT_EQ(changed[0].speed_mps, 1.5);
}

TEST_F(RobotUpdatesTest, RefuseImpossibleNumbersWithoutAnyChange) {
  league::SpecUpdate update = update_of({Side::kWest, 0});
  update.mass_kg = 2;
  update.speed_mps = 900;
  updates_.add({update}, errors_);
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_EQ(errors_[0].code, "ROBOT_SPECS");
  EXPECT_TRUE(updates_.close().empty());
}

TEST_F(RobotUpdatesTest, AreRefusedOnceTheGameHasBegun) {
  updates_.close();
  updates_.add({update_of({Side::kWest, 0})}, errors_);
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_EQ(errors_[0].code, "GAME_BEGUN");
}

// All robots of the yellow team become slow.
std::string slow_robots() {
  simulation::SimulatorCommand command;
  for (std::uint32_t robot = 0; robot < 6; ++robot) {
    simulation::RobotSpecs& specs = *command.mutable_config()->add_robot_specs();
    specs.mutable_id()->set_id(robot);
    specs.mutable_id()->set_team(1);
    specs.mutable_limits()->set_vel_absolute_max(0.2F);
  }
  return command.SerializeAsString();
}

void record_game_with_slow_robots(const std::filesystem::path& file) {
  const LiveOptions options = loopback_options(Pace::kPackets);
  SteadyFrameClock clock;
  LiveGame live(short_network_game(), options, clock, [] { return false; });
  Caller control(options.ports.control);
  control.say(slow_robots());
  EXPECT_EQ(control.hear(), "");  // no error
  const benchmarks::CommandingThread teams({options.ports.blue, options.ports.yellow}, 6, 2000);
  game::GamePrograms programs = game::GamePrograms::live(
      short_network_game(), {file},
      [&](const game::TeamConfiguration&, const strategies::TeamContext& team) {
        return live.make_network_team(team);
      });
  EXPECT_TRUE(programs.finish(live.play(nullptr, programs).record));
}

// Whether the recorded commands are those that the game needs and lead to the recorded state.
bool is_repeated(const game::GameConfiguration& game, game::GamePrograms& programs) {
  try {
    game::Game again(game, nullptr, programs.maker());
    while (again.step()) {
    }
    return programs.finish(again.record());
  } catch (const io::InputError&) {
    return false;
  }
}

TEST(GameWithUpdatedRobots, IsRepeatedFromItsRecord) {
  const TemporaryFolder folder;
  record_game_with_slow_robots(folder / "commands.gz");
  game::GamePrograms programs =
      game::GamePrograms::recorded(short_network_game(), folder / "commands.gz");
  const game::GameConfiguration game = programs.configured(short_network_game());
  EXPECT_NEAR(game::team_on(game, Side::kWest).robots[5].body.speed_mps, 0.2, 1e-6);
  EXPECT_EQ(game::team_on(game, Side::kEast).robots[5].body.speed_mps, 3);
  EXPECT_TRUE(is_repeated(game, programs));
}

TEST(GameWithUpdatedRobots, IsAnotherWithoutTheChanges) {
  const TemporaryFolder folder;
  record_game_with_slow_robots(folder / "commands.gz");
  game::GamePrograms programs =
      game::GamePrograms::recorded(short_network_game(), folder / "commands.gz");
  programs.configured(short_network_game());
  EXPECT_FALSE(is_repeated(short_network_game(), programs));
}

}  // namespace
}  // namespace autoref::live
