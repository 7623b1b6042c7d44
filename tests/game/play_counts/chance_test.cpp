// The chances of shots: what is measured about a shot, and the model's probabilities.
#include "game/play_counts/chance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "game/loop/game.hpp"
#include "soccer/rules/rule_book.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

constexpr RobotId kKicker{Side::kWest, 1};

// A shot by west from 2 m in front of the east goal of the paper's field, at its centre.
struct ShotScene {
  ShotScene() { put(kKicker, {0.9, 0}); }

  void put(RobotId id, const Vec2& position_m, const Vec2& robot_mps = {0, 0}) {
    now.robots[id.side].push_back({id.number, position_m, {1, 0}, robot_mps, 0});
  }
  ShotSituation situation() const {
    const sim::Touch kick{1, 0, kKicker, {1.025, 0}, true, ball_mps, vertical_mps};
    return shot_situation(kick, {{3.025, 0.1}, 0.5, true}, now, field);
  }

  Field field;
  sim::WorldState now;
  Vec2 ball_mps{4, 0.2};
  double vertical_mps = 0;
};

TEST(ShotSituation, MeasuresAnOpenGoal) {
  const ShotSituation shot = ShotScene().situation();
  // The goal is 0.7 m wide, less the ball's diameter: 2 atan(0.3285 / 2).
  const double goal_rad = 2 * std::atan(0.3285 / 2);
  EXPECT_DOUBLE_EQ(shot.distance_m, 2);
  EXPECT_NEAR(shot.opening_rad, goal_rad, 1e-6);
  EXPECT_NEAR(shot.time_s, 2 / std::hypot(4, 0.2), 1e-9);
  EXPECT_EQ(shot.keeper_m, kNoOpponent_m);
  EXPECT_EQ(shot.opponent_m, kNoOpponent_m);
  EXPECT_FALSE(shot.is_chip);
}

// A robot 1 m away covers asin(0.1115 / 1) to each side.
TEST(ShotSituation, SubtractsWhatRobotsCover) {
  ShotScene scene;
  scene.put({Side::kEast, 1}, {2.025, 0});
  const ShotSituation shot = scene.situation();
  const double side_rad = std::atan(0.3285 / 2) - std::asin(0.1115);
  EXPECT_NEAR(shot.opening_rad, side_rad, 0.01);
  EXPECT_NEAR(shot.opponent_m, 1, 1e-9);
}

TEST(ShotSituation, FindsTheWidestPartOfTheGoal) {
  for (const double aside_m : {-0.1, 0.1}) {
    ShotScene scene;
    scene.put({Side::kEast, 1}, {2.025, aside_m});
    const double wide_rad =
        std::atan(0.3285 / 2) + std::atan(0.1) - std::asin(0.1115 / std::hypot(1, 0.1));
    EXPECT_NEAR(scene.situation().opening_rad, wide_rad, 0.01);
  }
}

TEST(ShotSituation, IsCoveredByTheShootersMatesAsWell) {
  ShotScene scene;
  scene.put({Side::kWest, 2}, {1.225, 0});
  EXPECT_EQ(scene.situation().opening_rad, 0);
}

TEST(ShotSituation, MeasuresTheKeeper) {
  ShotScene scene;
  scene.put({Side::kEast, 1}, {1.5, 0});
  scene.put({Side::kEast, 0}, {2.725, 0.4}, {0, 0.7});
  const ShotSituation shot = scene.situation();
  EXPECT_NEAR(shot.keeper_out_m, 0.5, 1e-9);
  EXPECT_NEAR(shot.keeper_m, 0.4, 1e-9);
  EXPECT_NEAR(shot.keeper_mps, 0.7, 1e-9);
  // The path rises by 0.05 m per metre.
  EXPECT_NEAR(shot.keeper_to_path_m, (0.4 - 0.05 * 1.7) / std::hypot(1, 0.05), 1e-9);
  EXPECT_NEAR(shot.others_to_path_m, 0.05 * 0.475 / std::hypot(1, 0.05), 1e-9);
}

TEST(ShotSituation, KnowsChips) {
  ShotScene scene;
  scene.vertical_mps = 2;
  EXPECT_TRUE(scene.situation().is_chip);
}

TEST(ShotFeatures, AreLimitedMeasurements) {
  ShotSituation shot;
  shot.distance_m = 2.5;
  shot.opening_rad = 0.25;
  shot.time_s = 0.5;
  shot.keeper_m = 0.2;
  shot.keeper_out_m = 0.4;
  shot.keeper_mps = 1;
  shot.opponent_m = 0.6;
  shot.path.time_s = 0.6;
  shot.keeper_to_path_m = 0.1;
  shot.others_to_path_m = 0.25;
  const std::array<double, kChanceFeatures> chance = {1,   0.5, 0.5,          0.5, 0.2,
                                                      0.4, 1,   std::exp(-2), 0};
  const std::array<double, kTargetFeatures> target = {1,    0.1, 0.25, 0.6, 0.36,         0.06,
                                                      0.15, 1,   0,    1,   std::exp(-2), 0};
  for (std::size_t i = 0; i < chance.size(); ++i)
    EXPECT_NEAR(chance_features(shot)[i], chance[i], 1e-9) << i;
  for (std::size_t i = 0; i < target.size(); ++i)
    EXPECT_NEAR(target_features(shot)[i], target[i], 1e-9) << i;
}

TEST(ShotFeatures, DoNotGrowBeyondTheirLimits) {
  ShotSituation far;
  far.distance_m = far.time_s = far.keeper_mps = far.path.time_s = 5;
  ShotSituation farther;
  farther.distance_m = farther.time_s = farther.keeper_mps = farther.path.time_s = 10;
  EXPECT_EQ(chance_features(far), chance_features(farther));
  EXPECT_EQ(target_features(far), target_features(farther));
}

TEST(ChanceModel, ExistsForEveryRuleBook) {
  for (const std::string& name : rule_book_names()) EXPECT_EQ(chance_model(name).rules, name);
}

TEST(ChanceModel, KnowsThatAnOpenGoalIsABetterChance) {
  for (const ChanceModel& model : chance_models()) {
    ShotScene covered;
    covered.put({Side::kEast, 0}, {2.825, 0});
    covered.put({Side::kEast, 1}, {1.225, 0});
    const double open = model.chance(ShotScene().situation());
    const double closed = model.chance(covered.situation());
    EXPECT_GT(open, 0.4) << model.rules;
    EXPECT_LT(closed, 0.2) << model.rules;
    EXPECT_GT(model.chance_on_target(ShotScene().situation()), 0.4) << model.rules;
    EXPECT_LT(model.chance_on_target(covered.situation()), 0.2) << model.rules;
  }
}

TEST(ChanceModel, GivesNothingToAShotThatIsNotOnTarget) {
  ShotSituation shot = ShotScene().situation();
  shot.path.is_on_target = false;
  EXPECT_EQ(chance_model("paper").chance_on_target(shot), 0);
}

// Expected goals and goals of some games, in which the teams' strength varies.
TEST(ChanceModel, ExpectsAboutAsManyGoalsAsAreScored) {
  for (const char* rules : {"paper", "2026-b"}) {
    double xg = 0;
    double xgot = 0;
    int goals = 0;
    for (const char* team : {"basic", "counter", "cobalt"}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        GameConfiguration game = short_game_by(rules, 150, seed);
        game.a.strategy = team;
        game.b.strategy = "zone";
        const GameRecord record = play(game);
        for (const PlayCounts& counts : record.counts) {
          xg += counts.xg;
          xgot += counts.xgot;
        }
        goals += record.goals_a + record.goals_b;
      }
    }
    // Three standard deviations of a Poisson distribution.
    EXPECT_NEAR(xg, goals, 3 * std::sqrt(xg)) << rules;
    EXPECT_NEAR(xgot, goals, 3 * std::sqrt(xgot)) << rules;
    EXPECT_GT(goals, 5) << rules;
  }
}

}  // namespace
}  // namespace autoref::game
