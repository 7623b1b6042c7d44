#include <gtest/gtest.h>

#include "soccer/referee_signal.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/team_view.hpp"

namespace autoref {
namespace {

struct NumberedCommand {
  Command command;
  int number;
  const char* name;
};

class LeagueCommands : public testing::TestWithParam<NumberedCommand> {};

TEST_P(LeagueCommands, HaveTheLeaguesNumbersAndNames) {
  EXPECT_EQ(league_number(GetParam().command), GetParam().number);
  EXPECT_EQ(name_of(GetParam().command), GetParam().name);
}

// SSL_Referee.Command (2013); west is yellow.
INSTANTIATE_TEST_SUITE_P(
    Of2013, LeagueCommands,
    testing::Values(
        NumberedCommand{{CommandKind::kHalt, Side::kWest}, 0, "HALT"},
        NumberedCommand{{CommandKind::kStop, Side::kWest}, 1, "STOP"},
        NumberedCommand{{CommandKind::kNormalStart, Side::kWest}, 2, "NORMAL_START"},
        NumberedCommand{{CommandKind::kForceStart, Side::kWest}, 3, "FORCE_START"},
        NumberedCommand{{CommandKind::kPrepareKickoff, Side::kEast}, 5, "PREPARE_KICKOFF_BLUE"},
        NumberedCommand{{CommandKind::kPreparePenalty, Side::kWest}, 6, "PREPARE_PENALTY_YELLOW"},
        NumberedCommand{{CommandKind::kDirectFree, Side::kEast}, 9, "DIRECT_FREE_BLUE"},
        NumberedCommand{{CommandKind::kIndirectFree, Side::kWest}, 10, "INDIRECT_FREE_YELLOW"},
        NumberedCommand{{CommandKind::kTimeout, Side::kEast}, 13, "TIMEOUT_BLUE"},
        NumberedCommand{{CommandKind::kGoal, Side::kWest}, 14, "GOAL_YELLOW"},
        NumberedCommand{{CommandKind::kBallPlacement, Side::kEast}, 17, "BALL_PLACEMENT_BLUE"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Stages, HaveTheLeaguesNumbers) {
  EXPECT_EQ(static_cast<int>(Stage::kSecondHalf), 4);
  EXPECT_EQ(static_cast<int>(Stage::kPostGame), 13);
  EXPECT_EQ(name_of(Stage::kPostGame), "POST_GAME");
}

class SituationOfPlay : public testing::Test {
 protected:
  Situation after(CommandKind kind, Side side = Side::kWest, const Vec2& ball_m = {0, 0}) {
    signal_.command = {kind, side};
    ++signal_.command_counter;
    return tracker_.update(signal_, ball_m);
  }
  Situation next_frame(const Vec2& ball_m) { return tracker_.update(signal_, ball_m); }

  RefereeSignal signal_;
  SituationTracker tracker_{RuleBook{}};
};

TEST_F(SituationOfPlay, IsTheKickoffOfThePreparedSideAfterNormalStart) {
  after(CommandKind::kPrepareKickoff, Side::kEast);
  const Situation situation = after(CommandKind::kNormalStart);
  EXPECT_EQ(situation.play, Play::kKickoff);
  EXPECT_EQ(situation.side, Side::kEast);
}

TEST_F(SituationOfPlay, RunsOnceTheBallHasMovedMoreThan50Mm) {
  after(CommandKind::kDirectFree, Side::kEast, {1, 1});
  EXPECT_EQ(next_frame({1.049, 1}).play, Play::kDirectFree);
  EXPECT_EQ(next_frame({1.051, 1}).play, Play::kRunning);
}

TEST_F(SituationOfPlay, RunsAtOnceAfterForceStart) {
  after(CommandKind::kStop);
  EXPECT_EQ(after(CommandKind::kForceStart).play, Play::kRunning);
}

TEST_F(SituationOfPlay, StopsForAGoalAndHaltsForHalt) {
  after(CommandKind::kForceStart);
  EXPECT_EQ(after(CommandKind::kGoal).play, Play::kStop);
  EXPECT_EQ(after(CommandKind::kHalt).play, Play::kHalt);
}

}  // namespace
}  // namespace autoref
