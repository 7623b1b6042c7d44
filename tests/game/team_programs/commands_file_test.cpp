#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "game/team_programs/commands_reader.hpp"
#include "game/team_programs/commands_writer.hpp"
#include "io/errors.hpp"
#include "soccer/random.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/time_limit.hpp"

namespace autoref::game {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kState = 0x123456789abcdef0;

TeamEntry random_entry(RandomStream& random) {
  TeamEntry entry;
  for (RobotCommand& command : entry.commands) {
    if (random.uniform() < 0.5) continue;
    command.velocity_mps = Vec2(random.normal(), random.uniform() < 0.5 ? 0 : random.normal());
    command.angular_velocity_radps = random.normal() * 10;
    command.kick_mps = random.uniform() * 8;
    command.chip = random.uniform() < 0.5;
    command.dribble = random.uniform() < 0.5;
    command = transmitted(command);
  }
  entry.requests.keeper = static_cast<int>(random.uniform() * 17) - 1;
  if (random.uniform() < 0.5) entry.requests.leaves = static_cast<int>(random.uniform() * 16);
  entry.requests.timeout = random.uniform() < 0.5;
  return entry;
}

void expect_equal(const TeamEntry& read, const TeamEntry& written) {
  for (std::size_t i = 0; i < written.commands.size(); ++i) {
    EXPECT_EQ(read.commands[i].velocity_mps, written.commands[i].velocity_mps);
    EXPECT_EQ(read.commands[i].angular_velocity_radps, written.commands[i].angular_velocity_radps);
    EXPECT_EQ(read.commands[i].kick_mps, written.commands[i].kick_mps);
    EXPECT_EQ(read.commands[i].chip, written.commands[i].chip);
    EXPECT_EQ(read.commands[i].dribble, written.commands[i].dribble);
  }
  EXPECT_EQ(read.requests.keeper, written.requests.keeper);
  EXPECT_EQ(read.requests.leaves, written.requests.leaves);
  EXPECT_EQ(read.requests.timeout, written.requests.timeout);
  EXPECT_EQ(read.fault, written.fault);
}

class CommandsFile : public testing::Test {
 protected:
  TemporaryFolder folder_;
  const fs::path file_ = folder_.path() / "game.gz";
};

TEST_F(CommandsFile, IsReadAsItWasWritten) {
  RandomStream random(7);
  std::vector<TeamEntry> entries;
  CommandsWriter writer(file_);
  for (int i = 0; i < 400; ++i) {
    entries.push_back(random_entry(random));
    writer.add(i % 2 == 0 ? 'a' : 'b', entries.back());
  }
  TeamEntry last;
  last.fault = "ended with status 3";
  writer.add('a', last);
  writer.close(kState);
  CommandsReader reader(file_);
  for (int i = 0; i < 400; ++i)
    expect_equal(reader.next(i % 2 == 0 ? 'a' : 'b'), entries[static_cast<std::size_t>(i)]);
  EXPECT_EQ(reader.next('a').fault, "ended with status 3");
  EXPECT_EQ(reader.final_state(), kState);
}

TEST_F(CommandsFile, ContainsChangesOfTheWorld) {
  sim::BallState ball;
  ball.position_m = Vec2(1, -2);
  ball.velocity_mps = Vec2(0.5, 0);
  ball.height_m = 0.25;
  ball.is_rolling = false;
  PlacedRobot placed{{Side::kEast, 3}, {}};
  placed.state.number = 3;
  placed.state.heading = Vec2(0, -1);
  placed.state.angular_velocity_radps = 2;
  {
    CommandsWriter writer(file_);
    writer.add(ball);
    writer.add('a', {});
    writer.add(placed);
    writer.add(RemovedRobot{{Side::kWest, 5}});
    writer.close(kState);
  }
  CommandsReader reader(file_);
  const auto first = reader.read_step().value();
  ASSERT_EQ(first.size(), 1U);
  const auto read_ball = std::get<sim::BallState>(first[0]);
  EXPECT_EQ(read_ball.position_m, ball.position_m);
  EXPECT_EQ(read_ball.velocity_mps, ball.velocity_mps);
  EXPECT_EQ(read_ball.height_m, 0.25);
  EXPECT_FALSE(read_ball.is_rolling);
  reader.next('a');
  const auto last = reader.read_step().value();
  ASSERT_EQ(last.size(), 2U);
  const auto read_robot = std::get<PlacedRobot>(last[0]);
  EXPECT_EQ(read_robot.robot, (RobotId{Side::kEast, 3}));
  EXPECT_EQ(read_robot.state.heading, Vec2(0, -1));
  EXPECT_EQ(read_robot.state.angular_velocity_radps, 2);
  EXPECT_EQ(std::get<RemovedRobot>(last[1]).robot, (RobotId{Side::kWest, 5}));
  EXPECT_EQ(reader.final_state(), kState);
}

TEST_F(CommandsFile, ContainsChangesOfRobotsBeforeTheGame) {
  GameConfiguration game;
  ChangedRobot changed = unchanged({Side::kEast, 3}, game);
  changed.mass_kg = 2;
  changed.chip_limit_mps = 5;
  {
    CommandsWriter writer(file_);
    writer.add(changed);
    writer.add('a', {});
    writer.close(kState);
  }
  CommandsReader reader(file_);
  reader.change_robots(game);
  EXPECT_EQ(team_on(game, Side::kEast).robots[3].body.mass_kg, 2);
  EXPECT_EQ(team_on(game, Side::kEast).robots[3].kicker.chip_limit_mps, 5);
  EXPECT_EQ(team_on(game, Side::kEast).robots[3].body.speed_mps, 3);
  EXPECT_TRUE(reader.read_step().value().empty());
  reader.next('a');
  EXPECT_EQ(reader.final_state(), kState);
}

TEST_F(CommandsFile, WithRobotsThatTheGameDoesNotHaveIsRefused) {
  GameConfiguration game;
  ChangedRobot changed = unchanged({Side::kEast, 3}, game);
  changed.robot.number = 6;
  CommandsWriter writer(file_);
  writer.add(changed);
  writer.close(kState);
  CommandsReader reader(file_);
  EXPECT_THROW(reader.change_robots(game), io::InputError);
}

TEST_F(CommandsFile, AppearsOnlyWhenItIsClosed) {
  {
    CommandsWriter writer(file_);
    writer.add('a', {});
    EXPECT_FALSE(fs::exists(file_));
  }
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

// Like all outputs that a user names: pipes and devices are written to, not replaced.
TEST_F(CommandsFile, GoesThroughAPipeOfThatName) {
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  const int reader = open(file_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  CommandsWriter writer(file_, io::FileKind::kFileOrPipe);
  writer.close(kState);
  EXPECT_TRUE(fs::is_fifo(file_));
  std::array<unsigned char, 2> magic{};
  EXPECT_EQ(read(reader, magic.data(), magic.size()), 2);
  EXPECT_EQ(magic, (std::array<unsigned char, 2>{0x1f, 0x8b}));
  close(reader);
}

TEST_F(CommandsFile, IsNotReadFromAPipeThatHasItsName) {
  const TimeLimit limit;
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  EXPECT_THROW(CommandsReader{file_}, io::InputOutputError);
}

TEST_F(CommandsFile, IsReadFromAPipeThatTheUserNames) {
  const TimeLimit limit;
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  std::thread user([this] { CommandsWriter(file_, io::FileKind::kFileOrPipe).close(kState); });
  CommandsReader reader(file_, io::FileKind::kFileOrPipe);
  EXPECT_EQ(reader.final_state(), kState);
  user.join();
}

TEST_F(CommandsFile, OfAnotherGameIsRefused) {
  CommandsWriter writer(file_);
  writer.add('a', {});
  writer.add('a', {});
  writer.close(kState);
  CommandsReader reader(file_);
  EXPECT_THROW(reader.next('b'), io::InputError);
  CommandsReader again(file_);
  again.next('a');
  EXPECT_THROW(again.final_state(), io::InputError);
}

TEST_F(CommandsFile, ThatIsDamagedIsRefused) {
  std::ofstream(file_) << "nothing";
  EXPECT_THROW(CommandsReader{file_}, io::InputError);
  CommandsWriter writer(file_);
  RandomStream random(7);
  for (int i = 0; i < 100; ++i) writer.add('a', random_entry(random));
  writer.close(kState);
  fs::resize_file(file_, fs::file_size(file_) / 2);
  CommandsReader reader(file_);
  const auto read_all = [&reader] {
    for (int i = 0; i < 100; ++i) reader.next('a');
    reader.final_state();
  };
  EXPECT_THROW(read_all(), io::InputError);
}

constexpr int kSteps = 300;

// Writes steps with an entry of each team, and returns these entries.
std::vector<TeamEntry> write_steps(CommandsWriter& writer) {
  RandomStream random(7);
  std::vector<TeamEntry> entries;
  for (int i = 0; i < 2 * kSteps; ++i) {
    if (i % 20 == 0) writer.add(RemovedRobot{{Side::kWest, 5}});
    writer.add(i % 2 == 0 ? 'a' : 'b', entries.emplace_back(random_entry(random)));
  }
  return entries;
}

// Reads steps until one is missing; returns their number.
int read_steps(CommandsReader& reader, const std::vector<TeamEntry>& entries) {
  int steps = 0;
  while (const auto changes = reader.read_step()) {
    EXPECT_EQ(changes->size(), steps % 10 == 0 ? 1U : 0U);
    const auto first = static_cast<std::size_t>(2 * steps++);
    expect_equal(reader.next('a'), entries.at(first));
    expect_equal(reader.next('b'), entries.at(first + 1));
  }
  return steps;
}

TEST_F(CommandsFile, OfAnInterruptedGameEndsWithItsState) {
  CommandsWriter writer(file_);
  const std::vector<TeamEntry> entries = write_steps(writer);
  writer.close(kState, true);
  CommandsReader reader(file_);
  EXPECT_EQ(read_steps(reader, entries), kSteps);
  EXPECT_FALSE(reader.is_truncated());
  EXPECT_EQ(reader.final_state(), kState);
}

TEST_F(CommandsFile, ThatIsTruncatedHasTheStepsBefore) {
  std::vector<TeamEntry> entries;
  {
    CommandsWriter writer(file_);
    entries = write_steps(writer);
    writer.close(kState);
  }
  const auto size = static_cast<int>(fs::file_size(file_));
  int steps = kSteps + 1;
  for (const int percent : {99, 90, 77, 50, 23}) {
    fs::resize_file(file_, static_cast<std::uintmax_t>(size * percent / 100));
    CommandsReader reader(file_, io::FileKind::kFileOrPipe);
    const int read = read_steps(reader, entries);
    EXPECT_TRUE(reader.is_truncated());
    EXPECT_LT(read, steps);
    EXPECT_GT(read, 0);
    steps = read;
    CommandsReader own(file_);
    EXPECT_THROW(read_steps(own, entries), io::InputError);
  }
}

TEST_F(CommandsFile, ThatGrowsHasWhatWasAddedBeforeTheLastSecond) {
  CommandsWriter writer(file_, io::FileKind::kGrowing);
  writer.add('a', {});
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  for (int i = 0; i < 2; ++i) writer.add('a', {});
  CommandsReader reader(file_, io::FileKind::kFileOrPipe);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(reader.next('a').fault, "");
  EXPECT_THROW(reader.next('a'), io::InputError);
}

}  // namespace
}  // namespace autoref::game
