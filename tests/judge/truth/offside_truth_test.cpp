// True offsides, in staged worlds. Expected values follow the definition in referee/README.md.
#include <gtest/gtest.h>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr const char* kOffside = "offside";

RuleBook offside_book() {
  RuleBook rules = book("2014");
  rules.in_force[RuleId::kOffside] = true;
  return rules;
}

// West's robot 1 passes from x = 0.3 m to robot 0. East's keeper is 2.9 m from the halfway line.
struct OffsidePass : StagedGame {
  explicit OffsidePass(double receiver_x_m = 2.0, double defender_x_m = 1.0)
      : StagedGame(offside_book()) {
    world.put_robot(kWest0, {receiver_x_m, 1});
    world.put_robot(kWest1, {0.3, 1});
    world.put_robot(kEast1, {defender_x_m, -1.5}, {-1, 0});
    world.put_ball({defender_x_m - 0.2, -1.5});
    command(CommandKind::kForceStart);
  }
  // A touch before the pass, which is then not straight from the restart.
  void touch_by_east() {
    world.put_ball(world.robot(kEast1).position_m - Vec2(0.2, 0), {3, 0});
    frames(6);
  }
  void pass() {
    world.put_ball_at_plate(kWest1);
    world.command(kWest1).kick_mps = 3;
    frames(1);
    world.command(kWest1).kick_mps = 0;
    frames(5);
  }
  void receive() { seconds(1.2); }
};

TEST(TrueOffside, IsThatOfTheReceiverBeyondTheSecondLastDefender) {
  OffsidePass game;
  game.touch_by_east();
  game.pass();
  EXPECT_FALSE(game.has(kOffside));
  game.receive();
  ASSERT_EQ(game.times_s(kOffside).size(), 1U);
  EXPECT_EQ(game.first(kOffside).robot, kWest0);
  EXPECT_EQ(game.first(kOffside).offender, Side::kWest);
}

TEST(TrueOffside, IsNotStraightFromARestart) {
  OffsidePass game;
  game.pass();
  game.receive();
  EXPECT_FALSE(game.has(kOffside));
}

TEST(TrueOffside, IsNotInFrontOfTheSecondLastDefender) {
  for (const double defender_x_m : {1.9, 2.1}) {
    OffsidePass game(2.0, defender_x_m);
    game.touch_by_east();
    game.pass();
    game.receive();
    EXPECT_EQ(game.has(kOffside), defender_x_m < 2.0) << defender_x_m;
  }
}

TEST(TrueOffside, IsDecidedWhenThePassIsPlayed) {
  OffsidePass game;
  game.touch_by_east();
  game.pass();
  game.world.put_robot(kEast1, {2.5, -1.5}, {-1, 0});  // comes back too late
  game.receive();
  EXPECT_TRUE(game.has(kOffside));
}

TEST(TrueOffside, IsNotAfterAnOpponentsTouch) {
  OffsidePass game;
  game.touch_by_east();
  game.pass();
  game.touch_by_east();
  game.world.put_ball({1.7, 1}, {3, 0});
  game.frames(10);
  EXPECT_FALSE(game.has(kOffside));
}

TEST(TrueOffside, NeedsTwoOpponents) {
  OffsidePass game;
  game.touch_by_east();
  game.world.world.take_off(kEast0);
  game.pass();
  game.receive();
  EXPECT_FALSE(game.has(kOffside));
}

TEST(TrueOffside, IsInNoRuleBookOfTheLeague) {
  for (const std::string& name : rule_book_names()) {
    EXPECT_FALSE(book(name.c_str()).has(RuleId::kOffside)) << name;
  }
}

}  // namespace
}  // namespace autoref::judge::ground_truth
