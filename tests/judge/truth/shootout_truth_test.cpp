// True outcomes of the kicks of a shoot-out (Laws, appendix A; 2026, Shoot-Out), in staged worlds.
#include <gtest/gtest.h>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr const char* kFailed = "penalty_kick_failed";

// West's robot 1 takes a kick 2.8 m in front of east's goal; all other robots are behind it.
struct ShootoutKick : StagedGame {
  ShootoutKick(const char* rules, Stage stage) : StagedGame(book(rules)) {
    signal.stage = stage;
    world.put_robot(kWest0, {-2.0, 1});
    world.put_robot(kEast1, {-2.0, -1});
    world.put_robot(kEast0, {3.025 - kFrontDistance_m, 0.3}, {-1, 0});
    world.put_robot(kWest1, {0.13, 0});
    world.put_ball_at_plate(kWest1);
    command(CommandKind::kPreparePenalty, Side::kWest);
    command(CommandKind::kNormalStart);
  }
  void kick(double speed_mps, bool chip = false) {
    world.command(kWest1).kick_mps = speed_mps;
    world.command(kWest1).chip = chip;
    frames(1);
    world.command(kWest1).kick_mps = 0;
  }
};

TEST(TrueShootout, AGoalCounts) {
  for (const char* rules : {"paper", "2014", "2026-b"}) {
    ShootoutKick game(rules, Stage::kShootout);
    game.kick(5.0);
    game.seconds(1.2);
    EXPECT_EQ(game.names(), std::vector<std::string>{"goal"}) << rules;
  }
}

TEST(TrueShootout, AKickBesideTheGoalHasFailedUnderAllRuleBooks) {
  for (const char* rules : {"paper", "2014", "2026-b"}) {
    ShootoutKick game(rules, Stage::kShootout);
    game.kick(5.0);
    game.world.put_ball({2.0, 1.0}, {5.0, 0});
    game.seconds(0.5);
    EXPECT_EQ(game.names(), std::vector<std::string>{kFailed}) << rules;
    EXPECT_EQ(game.first(kFailed).offender, Side::kWest);
  }
}

TEST(TrueShootout, InAHalfOnlyTheRulesOf2026SayThatAKickHasFailed) {
  for (const char* rules : {"2014", "2026-b"}) {
    ShootoutKick game(rules, Stage::kSecondHalf);
    game.kick(5.0);
    game.world.put_ball({2.0, 1.0}, {5.0, 0});
    game.seconds(0.5);
    EXPECT_EQ(game.has(kFailed), book(rules).edition == Edition::kRules2026) << rules;
    EXPECT_EQ(game.has("goal_kick"), book(rules).edition == Edition::kLaws2014) << rules;
  }
}

TEST(TrueShootout, AKickThatIsNotTakenHasFailedAfterTenSeconds) {
  for (const char* rules : {"2014", "2026-b"}) {
    ShootoutKick game(rules, Stage::kShootout);
    game.seconds(9.8);
    EXPECT_TRUE(game.names().empty()) << rules;
    game.seconds(0.4);
    EXPECT_EQ(game.names(), std::vector<std::string>{kFailed}) << rules;
  }
}

TEST(TrueShootout, AChippedGoalHasFailedByTheLaws) {
  for (const char* rules : {"2014", "2026-b"}) {
    ShootoutKick game(rules, Stage::kShootout);
    game.kick(4.5, true);
    game.seconds(1.5);
    const bool is_laws = book(rules).edition == Edition::kLaws2014;
    EXPECT_EQ(game.names(), std::vector<std::string>{is_laws ? kFailed : "goal"}) << rules;
  }
}

TEST(TrueShootout, AGoalAtTheKickersEndHasFailed) {
  ShootoutKick game("2014", Stage::kShootout);
  game.kick(5.0);
  game.world.put_ball({-2.9, 0}, {-4.0, 0});
  game.seconds(0.3);
  EXPECT_EQ(game.names(), std::vector<std::string>{kFailed});
}

}  // namespace
}  // namespace autoref::judge::ground_truth
