#include "league/team/league_signal.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "soccer/team_view.hpp"

namespace autoref::league {
namespace {

constexpr Side kYellow = Side::kWest;
constexpr Side kBlue = Side::kEast;

// Shows a team what the referee sends, and compares it with what the team concludes.
class ConcludedSignal : public testing::TestWithParam<Side> {
 protected:
  const RefereeSignal& with_ball_at(const Vec2& ball_m) {
    tracks.time_s += 1;
    tracks.ball = TrackedBall{ball_m};
    const Situation situation = tracker.update(sent, ball_m);
    fill_view(tracks, sent, situation, GetParam(), view);
    return concluded.update(view);
  }

  const RefereeSignal& after(Command command) {
    sent.command = command;
    ++sent.command_counter;
    return with_ball_at(Vec2(0, 0));
  }

  RuleBook rules;
  SituationTracker tracker{rules};
  Tracks tracks;
  TeamView view;
  RefereeSignal sent;
  LeagueSignal concluded{GetParam(), 6};
};

INSTANTIATE_TEST_SUITE_P(Of, ConcludedSignal, testing::ValuesIn(kSides),
                         [](const auto& test) { return std::string(name_of(test.param)); });

TEST_P(ConcludedSignal, HasTheCommandsThatWereSent) {
  const std::vector<Command> commands = {{CommandKind::kStop},
                                         {CommandKind::kPrepareKickoff, kBlue},
                                         {CommandKind::kNormalStart},
                                         {CommandKind::kStop},
                                         {CommandKind::kBallPlacement, kYellow},
                                         {CommandKind::kStop},
                                         {CommandKind::kDirectFree, kBlue},
                                         {CommandKind::kStop},
                                         {CommandKind::kIndirectFree, kYellow},
                                         {CommandKind::kHalt},
                                         {CommandKind::kStop},
                                         {CommandKind::kForceStart},
                                         {CommandKind::kStop},
                                         {CommandKind::kPreparePenalty, kYellow},
                                         {CommandKind::kNormalStart}};
  for (const Command& command : commands) {
    EXPECT_EQ(name_of(after(command).command), name_of(command));
    EXPECT_EQ(concluded.signal().command_counter, sent.command_counter);
    EXPECT_EQ(concluded.signal().command_time_s, tracks.time_s);
  }
}

TEST_P(ConcludedSignal, KeepsTheCommandWhileTheBallIsInPlay) {
  after({CommandKind::kDirectFree, kBlue});
  ASSERT_EQ(with_ball_at(Vec2(1, 0)).command, (Command{CommandKind::kDirectFree, kBlue}));
  EXPECT_EQ(view.play, Play::kRunning);
  EXPECT_EQ(concluded.signal().command_counter, 1U);
  after({CommandKind::kDirectFree, kBlue});
  EXPECT_EQ(concluded.signal().command_counter, 2U);
}

TEST_P(ConcludedSignal, HasGoalsPlacementAndTheNextCommand) {
  sent.goals = {{2, 1}};
  sent.placement = Placement{{1, -2}};
  sent.next_command = Command{CommandKind::kDirectFree, kBlue};
  const RefereeSignal& signal = after({CommandKind::kStop});
  EXPECT_EQ(signal.goals, sent.goals);
  ASSERT_TRUE(signal.placement.has_value());
  EXPECT_EQ(signal.placement->target_m, Vec2(1, -2));
  EXPECT_EQ(signal.next_command, sent.next_command);
}

TEST_P(ConcludedSignal, CountsTheHalvesByTheTimeLeft) {
  const auto stage_at = [this](double time_left_s) {
    sent.stage_time_left_s = time_left_s;
    return with_ball_at(Vec2(0, 0)).stage;
  };
  EXPECT_EQ(stage_at(0), Stage::kFirstHalfPre);
  EXPECT_EQ(stage_at(300), Stage::kFirstHalf);
  EXPECT_EQ(stage_at(-0.5), Stage::kFirstHalf);
  EXPECT_EQ(stage_at(0), Stage::kSecondHalfPre);
  EXPECT_EQ(stage_at(300), Stage::kSecondHalf);
  EXPECT_EQ(stage_at(0), Stage::kExtraFirstHalfPre);
  stage_at(60);
  EXPECT_EQ(stage_at(0), Stage::kExtraSecondHalfPre);
  stage_at(60);
  EXPECT_EQ(stage_at(0), Stage::kShootoutBreak);
}

TEST_P(ConcludedSignal, TakesPenaltyKicksOutsideTheHalvesAsAShootOut) {
  after({CommandKind::kStop});
  EXPECT_EQ(after({CommandKind::kPreparePenalty, kBlue}).stage, Stage::kShootout);
  EXPECT_EQ(after({CommandKind::kStop}).stage, Stage::kShootout);
}

}  // namespace
}  // namespace autoref::league
