// match.after_game: the referee "can either signal for a new game to begin or simply leave the
// robots halted" (paper, section 4.2).
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "game/loop/event_log.hpp"
#include "game/loop/game.hpp"
#include "game/settings/fields.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

class Labels final : public Observer {
 public:
  void on_decision(const referee::Decision& decision) override {
    labels.emplace_back(decision.transition);
    lines.push_back(decision_json(decision));
  }
  std::vector<std::string> labels;
  std::vector<std::string> lines;
};

GameConfiguration game_then(referee::AfterGame after) {
  GameConfiguration game = short_game(20, 5);
  game.match.after_game = after;
  return game;
}

TEST(AfterGame, IsHaltByDefault) {
  EXPECT_EQ(value_at(GameSettings{}, "match.after_game"), "halt");
  GameSettings game;
  set_by_path(game, "match.after_game", "new_game");
  EXPECT_EQ(game.match.after_game, referee::AfterGame::kNewGame);
}

TEST(AfterGame, WithHaltStopsAtTheEnd) {
  Labels seen;
  const GameRecord record = play(game_then(referee::AfterGame::kHalt), &seen);
  ASSERT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(seen.labels.back(), "game_over");
}

TEST(AfterGame, WithNewGameTheRefereeBeginsAnother) {
  Labels seen;
  const GameRecord record = play(game_then(referee::AfterGame::kNewGame), &seen);
  ASSERT_EQ(record.status, Status::kOk) << record.void_reason;
  ASSERT_GE(seen.labels.size(), 2U);
  EXPECT_EQ(seen.labels[seen.labels.size() - 2], "game_over_next");
  EXPECT_EQ(seen.labels.back(), "new_game");
  EXPECT_NE(seen.lines.back().find(R"("to": "WAIT_STOP", "command": "STOP")"), std::string::npos)
      << seen.lines.back();
}

TEST(AfterGame, WithNewGameTheResultIsThatOfTheFinishedGame) {
  const GameRecord halted = play(game_then(referee::AfterGame::kHalt));
  const GameRecord followed = play(game_then(referee::AfterGame::kNewGame));
  EXPECT_EQ(followed.end_reason, EndReason::kTime);
  EXPECT_EQ(followed.goals_by_half, halted.goals_by_half);
  EXPECT_EQ(followed.goals_by_half.size(), 2U);
  EXPECT_EQ(followed.goals_a, halted.goals_a);
  EXPECT_EQ(followed.goals_b, halted.goals_b);
  EXPECT_EQ(followed.frames, halted.frames + 1);
}

TEST(AfterGame, WithNewGameAShootoutKeepsItsResult) {
  GameConfiguration game = game_then(referee::AfterGame::kNewGame);
  game.a.strategy = game.b.strategy = "dummy";
  game.match.half_s = 5;
  game.match.rules.extra_half_s = 4;
  game.match.knockout = true;
  const GameRecord record = play(game);
  EXPECT_EQ(record.end_reason, EndReason::kShootout);
  EXPECT_EQ(record.goals_by_half.size(), 4U);
  EXPECT_EQ(record.shootout, (std::array<int, 2>{0, 0}));
}

}  // namespace
}  // namespace autoref::game
