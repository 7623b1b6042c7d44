// Each mischief of `rowdy` does in the simulated world what it says. The west is rowdy, the east
// stands still unless told otherwise.
#include <gtest/gtest.h>

#include <cmath>

#include "soccer/trigonometry.hpp"
#include "strategies/rowdy/kinds.hpp"
#include "tests/runner/staged_game.hpp"

namespace autoref::runner {
namespace {

constexpr RobotId kKeeper{Side::kWest, 0};
constexpr RobotId kFirst{Side::kWest, 1};
constexpr RobotId kSecond{Side::kWest, 2};
constexpr RobotId kOpponent{Side::kEast, 0};

// A keeper and two field players who do nothing wrong but `kind`, and that always.
StagedTeam only(const std::string& kind) { return {"rowdy", 3, {{"otherwise", 0}, {kind, 1}}}; }

struct Mischief : StagedGame {
  explicit Mischief(const std::string& kind, const StagedTeam& east = {"dummy", 2, {}},
                    std::uint64_t seed = 1)
      : StagedGame(only(kind), east, {}, seed) {
    put_robot(kKeeper, {-2.9, 0});
    put_robot(kFirst, {-1.0, 0.4});
    put_robot(kSecond, {-1.0, -1.0});
  }
  void start() { command(CommandKind::kForceStart); }
  void restart(CommandKind kind, Side side) { command(kind, side); }

  double to_ball_m(RobotId id) const {
    const sim::RobotState& its = robot(id);
    return distance_to_hull(ball().position_m, its.position_m, its.heading) - kBallRadius_m;
  }
  // Of the nearest of the two field players.
  double nearest_to_ball_m() const { return std::min(to_ball_m(kFirst), to_ball_m(kSecond)); }
  // Of a robot's centre to the area of `side`; hulls reach 90 mm farther.
  double to_area_m(Side side, RobotId id) const {
    return distance_to_defence_area(field, side, robot(id).position_m);
  }
  bool touches_ball(RobotId id) const {
    for (const sim::Touch& touch : world.touches()) {
      if (touch.robot == id) return true;
    }
    return false;
  }
  double ball_mps() const { return ball().velocity_mps.norm(); }
};

TEST(Rowdy, KicksHarderThanBasicEverDoes) {
  Mischief game("hard_kick");
  game.put_robot(kFirst, {0.5, 0});
  game.put_ball({1, 0});
  game.start();
  EXPECT_TRUE(game.happens(5, [&] { return game.ball_mps() > 7.4; }));
}

TEST(Rowdy, ChipsIntoTheGoal) {
  Mischief game("chip_goal");
  game.put_robot(kFirst, {1.2, 0});
  game.put_ball({1.5, 0});
  game.start();
  double highest_m = 0;
  EXPECT_TRUE(game.happens(5, [&] {
    highest_m = std::max(highest_m, game.ball().height_m);
    return game.ball().position_m.x() > game.field.half_length_m() + kBallRadius_m;
  }));
  EXPECT_GT(highest_m, 0.15);
  EXPECT_LT(std::abs(game.ball().position_m.y()), game.field.half_goal_m());
}

TEST(Rowdy, ShootsStraightAtTheGoalFromAnIndirectFreeKick) {
  Mischief game("indirect_shot");
  game.put_robot(kSecond, {2.0, -0.9});  // to whom basic might pass
  game.put_ball({0.8, 1.2});
  game.restart(CommandKind::kIndirectFree, Side::kWest);
  EXPECT_TRUE(game.happens(
      10, [&] { return game.ball().position_m.x() > game.field.half_length_m() + kBallRadius_m; }));
  EXPECT_LT(std::abs(game.ball().position_m.y()), game.field.half_goal_m());
}

TEST(Rowdy, PlaysAFreeKickIntoItsOwnGoal) {
  Mischief game("own_goal_kick");
  game.put_ball({-1.5, 0.8});
  game.restart(CommandKind::kDirectFree, Side::kWest);
  bool others_touched = false;
  EXPECT_TRUE(game.happens(12, [&] {
    others_touched = others_touched || game.touches_ball(kKeeper);
    return game.ball().position_m.x() < -game.field.half_length_m() - kBallRadius_m;
  }));
  EXPECT_LT(std::abs(game.ball().position_m.y()), game.field.half_goal_m());
  EXPECT_FALSE(others_touched);
}

TEST(Rowdy, PlaysTheBallWithAFieldPlayerInItsOwnArea) {
  Mischief game("play_in_own_area");
  game.put_ball({-2.6, 0.2});
  game.start();
  EXPECT_TRUE(game.happens(6, [&] {
    return game.touches_ball(kFirst) && game.to_area_m(Side::kWest, kFirst) < -kRobotRadius_m;
  }));
}

TEST(Rowdy, TouchesTheBallWithAFieldPlayerPartlyInItsOwnArea) {
  Mischief game("play_at_own_area");
  game.put_ball({-3.025 + 0.75, 0.1});
  game.start();
  ASSERT_TRUE(game.happens(6, [&] { return game.touches_ball(kFirst); }));
  EXPECT_LT(game.to_area_m(Side::kWest, kFirst), kRobotRadius_m);
  EXPECT_GT(game.to_area_m(Side::kWest, kFirst), -kRobotRadius_m);
}

TEST(Rowdy, PlaysTheBallInTheOpponentsArea) {
  Mischief game("attack_in_area");
  game.put_robot(kFirst, {1.6, 0.5});
  game.put_ball({2.5, 0.2});
  game.start();
  EXPECT_TRUE(game.happens(6, [&] {
    return game.touches_ball(kFirst) && game.to_area_m(Side::kEast, kFirst) < kRobotRadius_m;
  }));
}

// Touches of the kicker that begin after the ball has moved 50 mm, up to anybody else's.
TEST(Rowdy, TouchesTheBallTwiceAtARestart) {
  for (const CommandKind kind : {CommandKind::kDirectFree, CommandKind::kIndirectFree}) {
    Mischief game("second_touch");
    const Vec2 from_m(-0.5, 1);
    game.put_ball(from_m);
    game.restart(kind, Side::kWest);
    ASSERT_TRUE(game.happens(12, [&] { return !game.world.touches().empty(); }));
    const RobotId kicker = game.world.touches()[0].robot;
    ASSERT_TRUE(game.happens(3, [&] { return game.to_ball_m(kicker) > 20_mm; }));
    EXPECT_TRUE(game.happens(5, [&] { return !game.world.touches().empty(); }));
    EXPECT_EQ(game.world.touches()[0].robot, kicker);
    EXPECT_GT((game.ball().position_m - from_m).norm(), 50_mm);
  }
}

TEST(Rowdy, StandsTooNearAtTheOpponentsRestarts) {
  Mischief game("crowd_restart");
  game.put_ball({0.5, 1});
  game.restart(CommandKind::kDirectFree, Side::kEast);
  game.run(5);
  EXPECT_LT(game.nearest_to_ball_m(), 0.4);
  EXPECT_GT(game.nearest_to_ball_m(), 0.1);
}

TEST(Rowdy, StandsNearTheBallWhilePlayIsStopped) {
  Mischief game("stop_crowd");
  game.put_ball({0.5, 1});
  ASSERT_TRUE(game.happens(4, [&] { return game.nearest_to_ball_m() < 0.4; }));
  game.run(2);
  EXPECT_LT(game.nearest_to_ball_m(), 0.4);
}

TEST(Rowdy, DrivesFastWhilePlayIsStopped) {
  Mischief game("stop_sprint");
  game.put_ball({1, 0});
  game.run(2.5);
  int fast_frames = 0;
  game.happens(3, [&] {
    const double first_mps = game.robot(kFirst).velocity_mps.norm();
    const double second_mps = game.robot(kSecond).velocity_mps.norm();
    fast_frames += std::max(first_mps, second_mps) > 1.6 ? 1 : 0;
    return false;
  });
  EXPECT_GT(fast_frames, 12);  // 0.2 s
}

// How far the first of the west's robots carries the ball in one go.
double dribbled_m(std::uint64_t seed) {
  Mischief game("long_dribble", {"dummy", 2, {}}, seed);
  game.put_robot(kFirst, {-1.2, 0});
  game.put_ball({-1.2 + kFrontDistance_m + kBallRadius_m + 2_mm, 0});
  game.start();
  const Vec2 from_m = game.ball().position_m;
  game.happens(6, [&] { return game.to_ball_m(kFirst) > 20_mm; });
  return (game.ball().position_m - from_m).norm();
}

TEST(Rowdy, DribblesTheBallNearAndFar) {
  double shortest_m = 9;
  double longest_m = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const double far_m = dribbled_m(seed);
    shortest_m = std::min(shortest_m, far_m);
    longest_m = std::max(longest_m, far_m);
  }
  EXPECT_GT(shortest_m, 0.25);
  EXPECT_LT(shortest_m, 0.6);
  EXPECT_GT(longest_m, 1.2);
  EXPECT_LT(longest_m, 1.8);
}

// The longest time for which the ball stays at the keeper inside its area.
double held_s(std::uint64_t seed) {
  Mischief game("keeper_hold", {"dummy", 2, {}}, seed);
  game.put_ball({-2.6, 0.1});
  game.start();
  int now = 0;
  int longest = 0;
  game.happens(25, [&] {
    const bool is_inside =
        distance_to_defence_area(game.field, Side::kWest, game.ball().position_m) < 0;
    now = is_inside && game.to_ball_m(kKeeper) < 20_mm ? now + 1 : 0;
    longest = std::max(longest, now);
    return false;
  });
  return longest / StagedGame::kRate_hz;
}

TEST(Rowdy, LetsItsKeeperHoldTheBall) {
  double shortest_s = 99;
  double longest_s = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const double time_s = held_s(seed);
    shortest_s = std::min(shortest_s, time_s);
    longest_s = std::max(longest_s, time_s);
  }
  EXPECT_GT(shortest_s, 2);
  EXPECT_LT(shortest_s, 8);
  EXPECT_GT(longest_s, 15);
}

// How fast the two closed in the frame before their hulls met; 0 if they never did.
double met_at_mps(StagedGame& game, RobotId one, RobotId other) {
  double before_mps = 0;
  const bool met = game.happens(5, [&] {
    const Vec2 apart_m = game.robot(other).position_m - game.robot(one).position_m;
    if (apart_m.norm() < 2 * kRobotRadius_m + 5_mm) return true;
    before_mps =
        (game.robot(one).velocity_mps - game.robot(other).velocity_mps).dot(apart_m.normalized());
    return false;
  });
  return met ? before_mps : 0;
}

TEST(Rowdy, RunsIntoAnOpponentAtSpeed) {
  Mischief game("ram");
  game.put_ball({2, 1.5});
  game.put_robot(kOpponent, {-0.1, -1.0});  // 0.9 m before kSecond
  game.start();
  EXPECT_GT(met_at_mps(game, kSecond, kOpponent), 1.6);
}

// An opponent that drives at 1.5 m/s towards the last of the others.
struct Chaser final : strategies::Strategy {
  void decide(const TeamView& view, TeamOrders& orders) override {
    if (view.own.empty() || view.opponents.empty()) return;
    const Vec2 way_m = view.opponents.back().position_m - view.own[0].position_m;
    orders[0].velocity_mps = to_local(1.5 * way_m.normalized(), view.own[0].heading);
  }
};

TEST(Rowdy, MeetsAnOpponentHeadOnAtEqualSpeeds) {
  Mischief game("ram_evenly");
  game.teams[Side::kEast] = std::make_unique<Chaser>();
  game.put_ball({2, 1.5});
  game.put_robot(kOpponent, {0.9, -1.0}, {-1, 0});
  game.start();
  double rammer_mps = 0;
  double opponent_mps = 0;
  ASSERT_TRUE(game.happens(4, [&] {
    const Vec2 apart_m = game.robot(kOpponent).position_m - game.robot(kSecond).position_m;
    if (apart_m.norm() < 2 * kRobotRadius_m + 5_mm) return true;
    rammer_mps = game.robot(kSecond).velocity_mps.dot(apart_m.normalized());
    opponent_mps = -game.robot(kOpponent).velocity_mps.dot(apart_m.normalized());
    return false;
  }));
  EXPECT_GT(rammer_mps + opponent_mps, 1.5);
  EXPECT_NEAR(rammer_mps, opponent_mps, 0.3);
}

TEST(Rowdy, PushesAnOpponentBack) {
  Mischief game("shove");
  game.put_ball({2, 1.5});
  const Vec2 from_m(-0.4, -1.0);
  game.put_robot(kOpponent, from_m);
  game.start();
  game.run(4);
  EXPECT_GT((game.robot(kOpponent).position_m - from_m).norm(), 0.2);
}

TEST(Rowdy, WaitsNearTheOpponentsAreaAtARestart) {
  Mischief game("near_area");
  game.put_robot(kFirst, {1.2, 0.4});
  game.put_ball({1, 1.9});
  game.run(5);
  game.restart(CommandKind::kDirectFree, Side::kEast);
  game.run(2);
  const double to_hull_m =
      std::min(game.to_area_m(Side::kEast, kFirst), game.to_area_m(Side::kEast, kSecond)) -
      kRobotRadius_m;
  EXPECT_LT(to_hull_m, 0.15);
  EXPECT_GT(to_hull_m, 0);
}

TEST(Rowdy, LetsItsRestartRunOut) {
  Mischief game("delay");
  game.put_ball({0.5, 1});
  game.restart(CommandKind::kDirectFree, Side::kWest);
  EXPECT_FALSE(game.happens(11, [&] { return !game.world.touches().empty(); }));
}

TEST(Rowdy, HasARobotInTheOpponentsHalfAtAKickoff) {
  for (const Side kicks_off : kSides) {
    Mischief game("kickoff_intruder");
    game.command(CommandKind::kPrepareKickoff, kicks_off);
    game.run(5);
    game.command(CommandKind::kNormalStart);
    game.run(0.2);
    const double front_x =
        std::max(game.robot(kFirst).position_m.x(), game.robot(kSecond).position_m.x());
    EXPECT_GT(front_x, kRobotRadius_m);
  }
}

TEST(Rowdy, SendsItsKeeperOffTheLineAtAPenalty) {
  Mischief game("keeper_off_line");
  game.put_ball(game.field.penalty_mark_at(Side::kWest));
  game.command(CommandKind::kPreparePenalty, Side::kEast);
  game.run(5);
  game.command(CommandKind::kNormalStart);
  game.run(1);
  EXPECT_GT(game.robot(kKeeper).position_m.x(), -game.field.half_length_m() + 0.2);
}

TEST(Rowdy, HasARobotBesideTheMarkAtPenalties) {
  for (const Side kicks : kSides) {
    Mischief game("penalty_crowd");
    const Vec2 mark_m = game.field.penalty_mark_at(opponent_of(kicks));
    game.put_ball(mark_m);
    game.command(CommandKind::kPreparePenalty, kicks);
    game.run(7);
    const auto is_beside = [&](RobotId id) {
      return std::abs(game.robot(id).position_m.x() - mark_m.x()) < 0.2 &&
             std::abs(game.robot(id).position_m.y() - mark_m.y()) > 0.3;
    };
    EXPECT_TRUE(is_beside(kFirst) || is_beside(kSecond)) << name_of(kicks);
  }
}

TEST(Rowdy, ShootsAimlesslyOverTheOpponentsGoalLine) {
  Mischief game("aimless_kick");
  game.put_ball({-0.7, 0.4});
  game.start();
  ASSERT_TRUE(game.happens(
      12, [&] { return game.ball().position_m.x() > game.field.half_length_m() + kBallRadius_m; }));
  EXPECT_GT(std::abs(game.ball().position_m.y()), game.field.half_goal_m());
}

TEST(Rowdy, AsksForATimeoutInAStopOnly) {
  Mischief game("timeout");
  EXPECT_TRUE(game.happens(1, [&] { return game.teams[Side::kWest]->requests().timeout; }));
  game.start();
  EXPECT_FALSE(game.happens(3, [&] { return game.teams[Side::kWest]->requests().timeout; }));
}

TEST(Rowdy, StandsStillInHalt) {
  for (const strategies::rowdy::Mischief* kind : strategies::rowdy::all_kinds()) {
    Mischief game{std::string(kind->name)};
    game.run(0.5);
    game.command(CommandKind::kHalt);
    game.frame();
    game.frame();
    for (const RobotCommand& order : game.orders[Side::kWest]) {
      ASSERT_EQ(order.velocity_mps, Vec2(0, 0)) << kind->name;
    }
  }
}

GameConfiguration rowdy_game(double half_s) {
  GameConfiguration game;
  game.match.half_s = half_s;
  game.a.strategy = game.b.strategy = "rowdy";
  return game;
}

TEST(Rowdy, PlaysGamesThatEnd) {
  for (const double share : {0.1, 1.0}) {
    GameConfiguration game = rowdy_game(60);
    game.a.params = game.b.params = {{"otherwise", share}};
    const GameRecord record = play(game);
    EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
    EXPECT_EQ(record.end_reason, EndReason::kTime);
  }
}

TEST(Rowdy, WithoutMischiefPlaysAsBasic) {
  GameConfiguration game = rowdy_game(30);
  game.a.params = game.b.params = {{"otherwise", 0}};
  const std::uint64_t hash = play(game).state_hash;
  game.a = game.b = TeamConfiguration{};
  EXPECT_EQ(play(game).state_hash, hash);
}

}  // namespace
}  // namespace autoref::runner
