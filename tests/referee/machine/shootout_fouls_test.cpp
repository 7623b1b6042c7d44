// Fouls in shoot-outs. Laws 2014, appendix A: "For all penalties, the rules of the penalty kick
// apply. ... As soon as the kicker touches the ball after he released it the first time the penalty
// is over." 2026: a shoot-out's attempts are penalty kicks, so a foul by the defenders is a goal,
// and a violation by the kicker's side is none.
#include <gtest/gtest.h>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

Configuration drawn_game(std::string_view book) {
  Configuration configuration = by_book(book);
  configuration.half_s = 3;
  configuration.rules.extra_half_s = 2;
  configuration.knockout = true;
  return configuration;
}

// A knockout game without goals, up to the signal for the first kick, which west takes.
struct ShootoutGame : ScriptedGame {
  explicit ShootoutGame(std::string_view book)
      : ScriptedGame(drawn_game(book)), field(drawn_game(book).field) {
    line_up(4).kick_off();
    run_until("shootout", 120);
    start_kick();
  }

  // The keepers are on their lines, the others 1.4 m behind the mark.
  void start_kick() {
    const Side kicker = run_until("prepare").command->side;
    const double mark_x_m = field.penalty_mark_at(opponent_of(kicker)).x();
    const double behind_m = mark_x_m + goal_sign(kicker) * 1.4;
    crash_x_m = mark_x_m + goal_sign(kicker) * 2;
    for (const Side side : kSides) {
      for (RobotObservation& robot : frame.robots[side]) {
        robot.position_m = {behind_m, goal_sign(side) * 0.5 * robot.number};
      }
      robot(side, 0).position_m = goal_sign(side) * Vec2(field.half_length_m() - 0.05, -0.2);
    }
    run_until("start");
  }

  // `side`'s robot 2 runs into an opponent at 2.5 m/s, far from the ball.
  void crash(Side side) {
    robot(side, 2).position_m = {crash_x_m, -1.6};
    robot(opponent_of(side), 2).position_m = {crash_x_m, 0.1};
    run(0.5);
    drive(side, 2, {0, 2.5}, 0.7);
  }

  // West's robot 1 kicks the ball slowly, and again 0.3 s later.
  void kick_twice(const Vec2& velocity_mps) {
    kick(Side::kWest, 1, {0.5, 0});
    run(0.3);
    robot(Side::kWest, 1).position_m =
        frame.ball->position_m - Vec2(kFrontDistance_m + kBallRadius_m, 0);
    ball_mps = velocity_mps;
  }

  void drive(Side side, int number, const Vec2& velocity_mps, double seconds) {
    for (int i = 0; i < seconds * kRate_hz; ++i) {
      robot(side, number).position_m += velocity_mps / kRate_hz;
      step();
    }
  }

  Field field;
  double crash_x_m = 0;
};

// The kick is west's until it is counted.
TEST(ShootoutByTheLaws, RepeatsAKickThatFailedWhileTheKeeperWasOffItsLine) {
  ShootoutGame game("2014");
  game.robot(Side::kEast, 0).position_m.x() -= 0.2;
  game.kick(Side::kWest, 1, {3, 3});
  const Decision again = game.run_until("penalty_positions", 2);
  EXPECT_EQ(again.finding.offender, Side::kEast);
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kPreparePenalty, Side::kWest}));
  EXPECT_EQ(game.count("shootout_miss"), 0);
}

TEST(ShootoutByTheLaws, CountsAGoalAgainstAKeeperOffItsLine) {
  ShootoutGame game("2014");
  game.robot(Side::kEast, 0).position_m.x() -= 0.2;
  game.kick(Side::kWest, 1, {4, 1});
  game.run_until("shootout_goal", 2);
}

TEST(ShootoutByTheLaws, EndsAKickWhenTheKickerTouchesTheBallAgain) {
  ShootoutGame game("2014");
  game.kick_twice({4, 1});
  game.run_until("shootout_miss", 0.5);
  EXPECT_EQ(game.count("attacker_double_touched_ball"), 1);
  EXPECT_EQ(game.signal.shootout_goals[Side::kWest], 0);
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kPreparePenalty, Side::kEast}));
}

TEST(ShootoutByTheLaws, EndsAKickAfterAFoulByTheKickersSide) {
  ShootoutGame game("2014");
  game.crash(Side::kWest);
  EXPECT_EQ(game.count("bot_crash_unique"), 1);
  EXPECT_EQ(game.count("shootout_miss"), 1);
}

TEST(ShootoutByTheLaws, GoesOnAfterAFoulByTheDefenders) {
  ShootoutGame game("2014");
  game.crash(Side::kEast);
  EXPECT_EQ(game.count("bot_crash_unique"), 1);
  EXPECT_EQ(game.referee.state(), State::kRun);
  game.kick(Side::kWest, 1, {4, 1});
  game.run_until("shootout_goal", 2);
}

TEST(ShootoutIn2026, IsAGoalAfterAFoulByTheDefenders) {
  ShootoutGame game("2026-b");
  game.crash(Side::kEast);
  EXPECT_EQ(game.count("bot_crash_unique"), 1);
  EXPECT_EQ(game.count("shootout_goal"), 1);
  EXPECT_EQ(game.signal.shootout_goals[Side::kWest], 1);
  EXPECT_EQ(game.signal.goals[Side::kWest], 0);
}

TEST(ShootoutIn2026, IsAMissAfterAFoulByTheKickersSide) {
  ShootoutGame game("2026-b");
  game.crash(Side::kWest);
  EXPECT_EQ(game.count("bot_crash_unique"), 1);
  EXPECT_EQ(game.count("shootout_miss"), 1);
}

// Every third foul brings a yellow card, also in a shoot-out. The second kick is east's own.
TEST(ShootoutIn2026, CountsFoulsTowardsCards) {
  ShootoutGame game("2026-b");
  game.crash(Side::kEast);
  game.start_kick();
  game.crash(Side::kEast);
  game.start_kick();
  EXPECT_EQ(game.signal.yellow_cards[Side::kEast], 0);
  game.crash(Side::kEast);
  EXPECT_EQ(game.count("bot_crash_unique"), 3);
  EXPECT_EQ(game.signal.yellow_cards[Side::kEast], 1);
  EXPECT_EQ(game.signal.shootout_goals, (PerSide<int>{{2, 0}}));
}

TEST(ShootoutIn2026, LetsTheKickerPlayTheBallAgain) {
  ShootoutGame game("2026-b");
  game.kick_twice({5, 0.3});
  game.run_until("shootout_goal", 3);
  EXPECT_EQ(game.count("attacker_double_touched_ball"), 0);
}

}  // namespace
}  // namespace autoref::referee
