#include "experiments/results/game_report.hpp"

#include <gtest/gtest.h>

#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

// Team a plays blue.
game::GameConfiguration game_of_blue_a() {
  game::GameConfiguration game;
  game.match.a_plays = Side::kEast;
  game.match.rules = *find_rule_book("2026-b");
  return game;
}

std::string text_for(game::EndReason reason, const std::string& void_reason = "") {
  game::GameRecord record;
  record.goals_a = 1;
  record.goals_b = 10;
  record.shootout = {{3, 2}};
  record.end_reason = reason;
  record.void_reason = void_reason;
  return end_text(game_of_blue_a(), record);
}

TEST(EndText, NamesTheReasonInPlainWords) {
  EXPECT_EQ(text_for(game::EndReason::kTime), "playing time ran out");
  EXPECT_EQ(text_for(game::EndReason::kGoals),
            "yellow (b) leads by 9 goals, and 10 goals are enough to win");
  EXPECT_EQ(text_for(game::EndReason::kShootout), "blue (a) won the shoot-out");
}

TEST(EndText, SaysWhoForfeitedAndWhy) {
  EXPECT_EQ(text_for(game::EndReason::kForfeitA, "team a ended (at 3.000 s)"),
            "blue (a) forfeited the game: team a ended (at 3.000 s)");
  EXPECT_EQ(text_for(game::EndReason::kForfeitB, "team b is late"),
            "yellow (b) forfeited the game: team b is late");
  EXPECT_EQ(text_for(game::EndReason::kVoid, "both failed"), "the game is void: both failed");
}

TEST(EndText, OfASceneSaysWhatEndedTheScene) {
  game::GameRecord record;
  record.scene = game::SceneRecord{};
  EXPECT_EQ(end_text(game_of_blue_a(), record), "the scene's time ran out");
  record.scene->ended_by = game::SceneEnd::kBallOut;
  EXPECT_EQ(end_text(game_of_blue_a(), record), "the ball left the field");
}

TEST(EndText, ClaimsNoReasonThatOnlyTheGameControllerKnows) {
  game::GameConfiguration game = game_of_blue_a();
  game.match.control = referee::Control::kGameController;
  EXPECT_EQ(end_text(game, {}), "the game controller ended the game");
}

TEST(EndText, IsPrintedAfterAGame) {
  const game::GameConfiguration game = game_of_blue_a();
  const game::GameRecord record;
  GameReport report{game, record, 2.0, "x"};
  EXPECT_TRUE(has(text_of(report), "\nended: playing time ran out\ncalls: none"));
  EXPECT_TRUE(has(json_of(report), R"("end_reason": "time")"));
  report.is_interrupted = true;
  EXPECT_TRUE(has(text_of(report), "\nended: the game was interrupted\ncalls: none"));
  EXPECT_TRUE(has(json_of(report), R"("end_reason": "interrupted")"));
}

}  // namespace
}  // namespace autoref::experiments
