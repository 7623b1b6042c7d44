// Crashes: Laws 2014, law 12, decision 1 (in the wording of 2018), and section "Crashing" of the
// 2026 rules.
#include <gtest/gtest.h>

#include "tests/referee/rules/driven_game.hpp"

namespace autoref::referee {
namespace {

// West 0 runs into east 0 along x, at the given speeds, starting 0.3 m before they meet. Both stop
// where they met.
struct Approach {
  double west_mps = 0;
  double east_mps = 0;
  double noise_m = 0;
  Vec2 met_m{-0.4, -0.8};
  double lateral_m = 0;  // between the centres, across the path
};

DrivenGame crash(const char* book, const Approach& run, double start = 0.0) {
  Configuration configuration = by_book(book);
  configuration.noise.robot_m = run.noise_m;
  DrivenGame game(configuration);
  const double duration_s = 0.5 + start / ScriptedGame::kRate_hz;
  const Vec2 apart_m(kRobotRadius_m, run.lateral_m / 2);
  game.put(kWest0, run.met_m - apart_m - Vec2(duration_s * run.west_mps, 0), {run.west_mps, 0});
  game.put(kEast0, run.met_m + apart_m + Vec2(duration_s * run.east_mps, 0), {-run.east_mps, 0});
  game.run(0.5, run.noise_m);
  game.drive(kWest0, {0, 0});
  game.drive(kEast0, {0, 0});
  game.run(0.5, run.noise_m);
  return game;
}

TEST(Crash, IsTheFasterRobotsFaultAboveOnePointFiveMetresPerSecond) {
  const DrivenGame game = crash("2014", {1.55, 0});
  ASSERT_EQ(game.calls(Event::kBotCrashUnique).size(), 1U);
  const Decision call = game.calls(Event::kBotCrashUnique).front();
  EXPECT_EQ(call.finding.offender, Side::kWest);
  EXPECT_EQ(call.finding.robots.front(), kWest0);
  EXPECT_EQ(call.finding.robots.back(), kEast0);
  EXPECT_NEAR(call.finding.value, 1.55, 0.02);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_LE((*call.finding.position_m - Vec2(-0.4, -0.8)).norm(), 0.02);
}

// Head-on, the angle between the velocities is pi; from behind it is 0.
TEST(Crash, HasTheDifferenceOfSpeedsAndTheAngleBetweenTheVelocities) {
  const Decision head_on = crash("2014", {1.2, 0.5}).calls(Event::kBotCrashUnique).front();
  EXPECT_NEAR(*head_on.finding.details.speed_difference_mps, 0.7, 0.02);
  EXPECT_NEAR(*head_on.finding.details.crash_angle_rad, 3.14159, 0.01);
  const Decision behind = crash("2014", {2.2, -0.5}).calls(Event::kBotCrashUnique).front();
  EXPECT_NEAR(*behind.finding.details.speed_difference_mps, 1.7, 0.02);
  EXPECT_NEAR(*behind.finding.details.crash_angle_rad, 0, 0.01);
}

TEST(Crash, IsNotCalledBelowTheLimit) {
  EXPECT_TRUE(crash("2014", {1.45, 0}).calls(Event::kBotCrashUnique).empty());
}

// The robot was faster than 1.5 m/s until the previous frame.
// The number of crashes called if a robot brakes at 3 m/s^2 and hits another one at that speed.
std::size_t crashes_after_braking_to(double last_mps) {
  DrivenGame game(by_book("2014"));
  constexpr double kFrame_s = 1 / ScriptedGame::kRate_hz;
  constexpr int kFrames = 20;
  constexpr double kSlower_mps = 3 * kFrame_s;  // in each frame
  const double path_m = kFrame_s * kFrames * (last_mps + kSlower_mps * (kFrames - 1) / 2);
  game.put(kEast0, {-0.4, -0.8}, {0, 0});
  game.put(kWest0, {-0.4 - 2 * kRobotRadius_m - path_m + 0.01, -0.8}, {0, 0});
  for (int i = kFrames - 1; i >= 0; --i) {
    game.drive(kWest0, {last_mps + i * kSlower_mps, 0});
    game.run(kFrame_s);
  }
  game.drive(kWest0, {0, 0});
  game.run(0.2);
  return game.calls(Event::kBotCrashUnique).size();
}

TEST(Crash, UsesABrakingRobotsSpeedAtTheCollision) {
  EXPECT_EQ(crashes_after_braking_to(1.46), 0U);
  EXPECT_EQ(crashes_after_braking_to(1.56), 1U);
}

TEST(Crash, AddsTheSpeedsOfBothRobots) {
  const DrivenGame game = crash("2014", {0.5, 1.1});
  ASSERT_EQ(game.calls(Event::kBotCrashUnique).size(), 1U);
  EXPECT_EQ(game.calls(Event::kBotCrashUnique).front().finding.offender, Side::kEast);
}

TEST(Crash, CountsOnlyTheComponentAlongTheLineOfTheCentres) {
  // At a lateral offset of 0.16 m and a distance of 0.18 m between the centres, 2.5 m/s is 1.15 m/s
  // along the line of centres.
  Approach aside{2.5, 0};
  aside.lateral_m = 0.16;
  EXPECT_TRUE(crash("2014", aside).calls(Event::kBotCrashUnique).empty());
}

TEST(Crash, IsSeenAtAnyMomentBetweenTwoFrames) {
  for (const double start : {-0.9, -0.6, -0.3, 0.0}) {
    const DrivenGame game = crash("2014", {3.0, 0.5}, start);
    ASSERT_EQ(game.calls(Event::kBotCrashUnique).size(), 1U) << start;
    EXPECT_NEAR(game.calls(Event::kBotCrashUnique).front().finding.value, 3.5, 0.05) << start;
  }
}

// The robots stop 29 mm apart, less than they drove in the last frame.
TEST(Crash, IsNotCalledIfRobotsStopBeforeTheyTouch) {
  EXPECT_TRUE(crash("2014", {3.0, 0.5}, 0.5).calls(Event::kBotCrashUnique).empty());
}

TEST(Crash, IsNobodysFaultByTheLawsIfSpeedsDifferLittle) {
  const DrivenGame game = crash("2014", {1.0, 0.75});
  EXPECT_TRUE(game.calls(Event::kBotCrashUnique).empty());
  EXPECT_TRUE(game.calls(Event::kBotCrashDrawn).empty());
}

TEST(Crash, IsAFoulByBothSidesIn2026IfSpeedsDifferLittle) {
  const DrivenGame game = crash("2026-b", {1.0, 0.75});
  ASSERT_EQ(game.calls(Event::kBotCrashDrawn).size(), 1U);
  EXPECT_EQ(game.calls(Event::kBotCrashDrawn).front().finding.offender, std::nullopt);
  EXPECT_EQ(game.calls(Event::kBotCrashDrawn).front().finding.robots.size(), 2U);
  EXPECT_TRUE(crash("2026-b", {1.2, 0.85}).calls(Event::kBotCrashDrawn).empty());
}

TEST(Crash, DoesNotStopPlayIn2026) {
  const DrivenGame game = crash("2026-b", {2.0, 0});
  EXPECT_EQ(game.calls(Event::kBotCrashUnique).size(), 1U);
  EXPECT_EQ(game.game.referee.state(), State::kRun);
}

TEST(Crash, InsideTheOffendersOwnAreaIsAPenaltyKickByTheLaws) {
  DrivenGame game(by_book("2014"));
  game.put(kEast0, {2.6, 0.1}, {-2.0, 0});
  game.put(kWest0, {2.26, 0.1}, {0, 0});
  game.run(0.3);
  ASSERT_EQ(game.calls(Event::kBotCrashUnique).size(), 1U);
  const Decision call = game.calls(Event::kBotCrashUnique).front();
  EXPECT_EQ(call.restart(), (Command{CommandKind::kPreparePenalty, Side::kWest}));
  EXPECT_EQ(game.game.signal.placement->target_m, Vec2(3.025 - 0.75, 0));
}

TEST(Crash, IsCalledOnceWhileRobotsBounceOffEachOther) {
  DrivenGame game(by_book("2026-b"));
  game.put(kWest0, {-0.6, -0.8}, {2.0, 0});
  game.put(kEast0, {0.0, -0.8}, {0, 0});
  for (int i = 0; i < 4; ++i) {
    game.run(0.21);
    game.drive(kWest0, {-0.6, 0});
    game.run(0.06);
    game.drive(kWest0, {2.0, 0});
    game.run(0.02);
  }
  EXPECT_EQ(game.calls(Event::kBotCrashUnique).size(), 1U);
}

// With this noise the speed is known to 0.08 m/s, and the call allows for as much.
TEST(Crash, IsNeitherMissedNorInventedUnderNoise) {
  for (int i = 0; i < 20; ++i) {
    const double start = -0.05 * i;  // the moment between two frames
    Approach run{1.95, 0, 0.0013};
    EXPECT_EQ(crash("2014", run, start).calls(Event::kBotCrashUnique).size(), 1U) << i;
    run.west_mps = 1.25;
    EXPECT_TRUE(crash("2014", run, start).calls(Event::kBotCrashUnique).empty()) << i;
  }
}

TEST(Crash, IsNotAFoulInThePaper) {
  EXPECT_TRUE(crash("paper", {3.0, 0}).calls(Event::kBotCrashUnique).empty());
}

TEST(Crash, IsNotCalledIfBothSidesCauseOneAtOnce) {
  DrivenGame game(by_book("2014"));
  game.put(kWest0, {-0.6, -0.8}, {2.0, 0});
  game.put(kEast0, {0.0, -0.8}, {0, 0});
  game.put({Side::kEast, 1}, {0.6, 0.8}, {-2.0, 0});
  game.put({Side::kWest, 1}, {0.0, 0.8}, {0, 0});
  game.run(0.5);
  EXPECT_TRUE(game.calls(Event::kBotCrashUnique).empty());
}

}  // namespace
}  // namespace autoref::referee
