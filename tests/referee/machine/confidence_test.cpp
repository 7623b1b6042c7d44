// How sure the referee is of its calls.
#include "referee/machine/confidence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

Decision throw_in_with(const tracking::VisionNoise& noise) {
  Configuration configuration;
  configuration.noise = noise;
  ScriptedGame game = in_play(configuration);
  game.kick_from(Side::kWest, 1, {0.5, 1.2}, {0, 3});
  return game.run_until("throw_in", 2);
}

// Yellow 2 runs into blue 2 at 2.5 m/s.
int crashes_called(double least_confidence) {
  Configuration configuration = by_book("2026-b");
  configuration.least_confidence = least_confidence;
  ScriptedGame game = in_play(configuration);
  game.robot(Side::kEast, 2).position_m = {-2, 0};
  for (int i = 0; i < ScriptedGame::kRate_hz; ++i) {
    game.robot(Side::kWest, 2).position_m = {-2, 2.5 - i * 2.5 / ScriptedGame::kRate_hz};
    game.step();
  }
  return game.count("bot_crash_unique");
}

TEST(Confidence, IsTheLogisticFunctionOfTheFeatures) {
  EXPECT_DOUBLE_EQ(confidence_by({0, 0, 0, 0, 0}, {1, 1, 1, 1, 1}), 0.5);
  EXPECT_DOUBLE_EQ(confidence_by({std::log(9.0), 5, 0, 0, 0}, {1, 0, 1, 1, 1}), 0.9);
  EXPECT_NEAR(confidence_by({1, -1, 2, -3, 0.5}, {1, 0.5, 0.25, 0.1, 1}), 0.7685, 1e-4);
}

TEST(Confidence, OfACallIsBetweenHalfAndCertainty) {
  const Finding call = throw_in_with({}).finding;
  EXPECT_GT(call.confidence, 0.5);
  EXPECT_LT(call.confidence, 1);
  EXPECT_EQ(call.confidence_features[0], 1);
  EXPECT_EQ(call.confidence_features[1], 0);
}

TEST(Confidence, KnowsTheNoiseOfVision) {
  const Finding call = throw_in_with({0.003, 0.004, 0}).finding;
  EXPECT_NEAR(call.confidence_features[1], 0.25, 1e-12);  // 5 of 20 mm
}

TEST(Confidence, OfWhatIsNoCallIsOne) {
  ScriptedGame game;
  game.line_up().kick_off();
  EXPECT_EQ(game.decisions.back().finding.confidence, 1);
}

TEST(LeastConfidence, SuppressesFoulsThatAreLessCertain) {
  EXPECT_EQ(crashes_called(0), 1);
  EXPECT_EQ(crashes_called(1), 0);
}

TEST(LeastConfidence, DoesNotSuppressExits) {
  Configuration configuration;
  configuration.least_confidence = 1;
  ScriptedGame game = in_play(configuration);
  game.kick_from(Side::kWest, 1, {0.5, 1.2}, {0, 3});
  EXPECT_EQ(game.run_until("throw_in", 2).transition, "throw_in");
}

}  // namespace
}  // namespace autoref::referee
