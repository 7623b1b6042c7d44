#include "strategies/tactics/pass_field.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

using Receivers = boost::container::static_vector<int, kMaxRobots>;

// Observes the world for a number of frames and sends the receivers in each of them.
void send(StagedPrediction& stage, PassField& field, const Receivers& receivers, int frames = 60) {
  for (int i = 0; i < frames; ++i) {
    stage.look(1);
    field.update();
    field.send(receivers);
  }
}

// Where the receiver goes if a fan of robots that no ball gets through covers that side (1: left).
Vec2 position_beside_fan_m(double side) {
  StagedPrediction stage(Play::kRunning);
  stage.world.ball({-0.5, 0}).own(0, {-2.8, 0}).own(1, {0.5, 0});
  for (int i = 0; i < 4; ++i) {
    const Vec2 direction = heading_of(side * (15_deg + i * 25_deg));
    stage.world.opponent(i, Vec2(-0.5, 0) + 0.5 * direction);
  }
  PassField field(stage.predicted);
  send(stage, field, {1});
  return field.position_of(1);
}

TEST(PassField, SendsAReceiverToTheSideThatNobodyCovers) {
  EXPECT_LT(position_beside_fan_m(1).y(), 0);
  EXPECT_GT(position_beside_fan_m(-1).y(), 0);
  EXPECT_GT(position_beside_fan_m(1).x(), 0);
  EXPECT_GT(position_beside_fan_m(-1).x(), 0);
}

TEST(PassField, SendsNobodyBehindAnOpponentThatBlocksThePass) {
  StagedPrediction stage(Play::kRunning);
  stage.world.ball({0, 0}).own(0, {-2.8, 0}).own(1, {1, 0}).opponent(0, {0.3, 0});
  PassField field(stage.predicted);
  send(stage, field, {1});
  EXPECT_GT(distance_to_segment({0.3, 0}, {0, 0}, field.position_of(1)),
            kRobotRadius_m + kBallRadius_m);
}

TEST(PassField, KeepsReceiversApart) {
  StagedPrediction stage(Play::kRunning);
  stage.world.ball({0, 0}).own(0, {-2.8, 0}).own(1, {1, 0.1}).own(2, {1, -0.1}).own(3, {0.9, 0});
  PassField field(stage.predicted);
  send(stage, field, {1, 2, 3});
  EXPECT_GT((field.position_of(1) - field.position_of(2)).norm(), 0.55);
  EXPECT_GT((field.position_of(1) - field.position_of(3)).norm(), 0.55);
  EXPECT_GT((field.position_of(2) - field.position_of(3)).norm(), 0.55);
}

TEST(PassField, KeepsReceiversAwayFromTheBall) {
  StagedPrediction stage(Play::kRunning);
  stage.world.ball({1.5, 0}).own(0, {-2.8, 0}).own(1, {1.4, 0.3});
  PassField field(stage.predicted);
  send(stage, field, {1});
  EXPECT_GT((field.position_of(1) - Vec2(1.5, 0)).norm(), 0.5);
}

// Where receivers 2 and 3 are sent in each of 90 frames, without repetitions.
std::vector<std::pair<Vec2, Vec2>> different_positions(StagedPrediction& stage, PassField& field) {
  std::vector<std::pair<Vec2, Vec2>> different;
  for (int i = 0; i < 90; ++i) {
    send(stage, field, {2, 3}, 1);
    const std::pair<Vec2, Vec2> now_m(field.position_of(2), field.position_of(3));
    if (different.empty() || different.back() != now_m) different.push_back(now_m);
  }
  return different;
}

TEST(PassField, KeepsPositionsIfNothingChanges) {
  StagedPrediction stage(Play::kRunning);
  stage.world.six_against_six().ball({-0.2, 0.3});
  PassField field(stage.predicted);
  send(stage, field, {2, 3}, 90);
  const std::pair<Vec2, Vec2> first_m(field.position_of(2), field.position_of(3));
  EXPECT_EQ(different_positions(stage, field), std::vector{first_m});
}

TEST(PassField, ChangesNoPositionDuringARestart) {
  StagedPrediction stage(Play::kStop);
  stage.world.own(0, {-2.8, 0}).own(1, {1, 0}).opponent(0, {0.5, 0.7}).ball({-0.5, 0});
  PassField field(stage.predicted);
  send(stage, field, {1});
  const Vec2 before_m = field.position_of(1);
  stage.world.view.play = Play::kDirectFree;
  stage.world.view.opponents[0].position_m = before_m;
  send(stage, field, {1});
  EXPECT_EQ(field.position_of(1), before_m);
  stage.world.view.play = Play::kRunning;
  send(stage, field, {1});
  EXPECT_NE(field.position_of(1), before_m);
}

TEST(PassField, ChoosesByWhatChangedSinceTheLastChoice) {
  constexpr int kHold_frames = 20;
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {-2.8, 0}).own(1, {1, 0}).opponent(0, {0.5, 0.7}).ball({-0.5, 0});
  PassField field(stage.predicted);
  send(stage, field, {1}, 1 + 2 * kHold_frames);  // chooses in the first frame and in the last
  const Vec2 before_m = field.position_of(1);
  stage.world.view.opponents[0].position_m = before_m / 2 + Vec2(-0.25, 0);
  send(stage, field, {1}, kHold_frames - 1);
  EXPECT_EQ(field.position_of(1), before_m);
  send(stage, field, {1}, 1);
  EXPECT_NE(field.position_of(1), before_m);
}

class PassFieldUnder : public testing::TestWithParam<const char*> {};

void expect_outside_area(const Field& field, const Vec2& position_m) {
  EXPECT_TRUE(is_on_field(field, position_m)) << position_m.transpose();
  EXPECT_GE(distance_to_defence_area(field, Side::kEast, position_m), kRobotRadius_m)
      << position_m.transpose();
}

TEST_P(PassFieldUnder, ChoosesPositionsOnTheFieldOutsideTheOpponentsArea) {
  const TeamContext context = team_context_of(GetParam());
  StagedPrediction stage(Play::kRunning, false, context);
  stage.world.ball({1, 0}).own(0, {-2.8, 0}).own(1, {2, 0.5}).own(2, {2, -0.5}).own(3, {1, 1.5});
  PassField field(stage.predicted);
  send(stage, field, {1, 2, 3});
  expect_outside_area(context.field, field.position_of(1));
  expect_outside_area(context.field, field.position_of(2));
  expect_outside_area(context.field, field.position_of(3));
}

INSTANTIATE_TEST_SUITE_P(Books, PassFieldUnder, testing::Values("paper", "2014-double"),
                         name_of_rule_book);

TEST(WorthOf, IsLargerIfThePassAllowsAFirstTimeShot) {
  StagedPrediction stage(Play::kRunning);
  const PredictedState& predicted = stage.look();
  const Vec2 point_m(2, 1);
  const double from_ahead = worth_of(predicted, 0.6, point_m, {2.2, -1.5});
  const double from_behind = worth_of(predicted, 0.6, point_m, {-1, 1.5});
  EXPECT_GT(from_ahead, 1.3 * from_behind);
}

TEST(WorthOf, GrowsWithTheChanceAndTowardsTheGoal) {
  StagedPrediction stage(Play::kRunning);
  const PredictedState& predicted = stage.look();
  EXPECT_GT(worth_of(predicted, 0.8, {1, 0}, {0, 0}), worth_of(predicted, 0.3, {1, 0}, {0, 0}));
  EXPECT_GT(worth_of(predicted, 0, {2, 0}, {0, 0}), worth_of(predicted, 0, {-1, 0}, {0, 0}));
}

}  // namespace
}  // namespace autoref::strategies
