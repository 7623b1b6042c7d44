#include "game/loop/game.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "io/errors.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

TEST(Game, OfBasicAgainstItselfEndsByTimeAfterBothHalves) {
  const GameRecord record = play(short_game(60, 1));
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(record.end_reason, EndReason::kTime);
  ASSERT_EQ(record.goals_by_half.size(), 2U);
  EXPECT_EQ(record.goals_by_half[0][0] + record.goals_by_half[1][0], record.goals_a);
  EXPECT_GT(record.sim_s, 120);
  EXPECT_GT(record.ball_in_play_s, 30);
}

TEST(Game, AgainstDummyStartsAndEndsByItselfAndIsWon) {
  GameConfiguration game = short_game(60, 2);
  game.b.strategy = "dummy";
  const GameRecord record = play(game);
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_GT(record.goals_a, record.goals_b);
}

TEST(Game, OfTwoDummiesStartsAndEndsByItselfWithoutAGoal) {
  GameConfiguration game = short_game(60, 3);
  game.a.strategy = game.b.strategy = "dummy";
  const GameRecord record = play(game);
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(record.goals_a + record.goals_b, 0);
  EXPECT_EQ(record.events[static_cast<int>(referee::Event::kStartTimeout)], 1);
  EXPECT_GT(record.events[static_cast<int>(referee::Event::kRestartNotTaken)], 0);
}

TEST(Game, IsIdenticalForTheSameSeedAndDiffersForAnother) {
  const std::uint64_t hash = play(short_game(30, 4)).state_hash;
  EXPECT_EQ(play(short_game(30, 4)).state_hash, hash);
  EXPECT_NE(play(short_game(30, 5)).state_hash, hash);
}

TEST(Game, OfATeamAgainstItselfHasTheOppositeScoreWithEndsChanged) {
  int goals = 0;
  for (std::uint64_t seed = 1; seed <= AUTOREF_TURNED_GAMES; ++seed) {
    GameConfiguration game = short_game(120, seed);
    const GameRecord west = play(game);
    game.match.a_plays = Side::kEast;
    const GameRecord east = play(game);
    EXPECT_EQ(west.goals_a, east.goals_b);
    EXPECT_EQ(west.goals_b, east.goals_a);
    EXPECT_EQ(west.counts[0], east.counts[1]);
    EXPECT_EQ(west.counts[1], east.counts[0]);
    EXPECT_EQ(west.state_hash, east.state_hash);
    goals += west.goals_a + west.goals_b;
  }
  EXPECT_GT(goals, 0) << "no goals were scored, so nothing was compared";
}

// Faulty teams, as a user might write them.
class Thrower final : public strategies::Strategy {
 public:
  void decide(const TeamView& view, TeamCommands& /*commands*/) override {
    if (view.time_s > 1) throw std::runtime_error("no plan");
  }
};

class Recorder final : public strategies::Strategy {
 public:
  void decide(const TeamView& view, TeamCommands& /*commands*/) override {
    if (view.time_s > 1) throw io::InputOutputError("no space left");
  }
};

class NotANumber final : public strategies::Strategy {
 public:
  void decide(const TeamView& view, TeamCommands& commands) override {
    if (view.time_s > 1) commands[2].velocity_mps.x() = std::numeric_limits<double>::quiet_NaN();
  }
};

template <typename Faulty>
GameRecord play_with_faulty_b() {
  GameConfiguration game = short_game(30, 6);
  game.b.strategy = "faulty";
  return play(game, nullptr,
              [](const TeamConfiguration& team,
                 const strategies::TeamContext& context) -> std::unique_ptr<strategies::Strategy> {
                if (team.strategy == "faulty") return std::make_unique<Faulty>();
                return make_registered_team(team, context);
              });
}

TEST(Game, IsVoidAndNamesTheTeamIfAStrategyThrows) {
  const GameRecord record = play_with_faulty_b<Thrower>();
  EXPECT_EQ(record.status, Status::kVoid);
  EXPECT_EQ(record.end_reason, EndReason::kVoid);
  EXPECT_NE(record.void_reason.find("team b threw: no plan"), std::string::npos)
      << record.void_reason;
}

TEST(Game, HasNoResultIfAFileOfATeamCannotBeWritten) {
  EXPECT_THROW(play_with_faulty_b<Recorder>(), io::InputOutputError);
}

TEST(Game, IsVoidAndNamesTheRobotIfACommandIsNotFinite) {
  const GameRecord record = play_with_faulty_b<NotANumber>();
  EXPECT_EQ(record.status, Status::kVoid);
  EXPECT_NE(
      record.void_reason.find("team b sent a command for robot 2 with a value that is not finite"),
      std::string::npos)
      << record.void_reason;
}

TEST(Game, RefusesUnknownNamesAndNumbersOutOfRange) {
  GameConfiguration game;
  game.a.strategy = "nobody";
  EXPECT_THROW(play(game), std::invalid_argument);
  game = GameConfiguration();
  game.sim.vision.ball_misses = 2;
  EXPECT_THROW(play(game), std::invalid_argument);
}

TEST(Game, IsPlayedWithOneRobotPerSideAndWithSixteen) {
  for (const std::size_t robots : {1U, 16U}) {
    GameConfiguration game = short_game(20, 7);
    game.a.robots.resize(robots);
    game.b.robots.resize(robots);
    EXPECT_EQ(play(game).status, Status::kOk) << robots;
  }
}

}  // namespace
}  // namespace autoref::game
