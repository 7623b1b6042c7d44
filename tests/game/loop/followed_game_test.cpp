// Games that somebody else commands.
#include <gtest/gtest.h>

#include <vector>

#include "game/loop/game.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

GameConfiguration commanded_game() {
  GameConfiguration game = short_game(30, 4);
  game.match.control = referee::Control::kGameController;
  return game;
}

RefereeSignal given(CommandKind kind, std::uint32_t counter) {
  RefereeSignal signal;
  signal.command = {kind, Side::kWest};
  signal.command_counter = counter;
  return signal;
}

TEST(CommandedGame, IsVoidWithoutAController) {
  Game game(commanded_game());
  EXPECT_FALSE(game.step());
  EXPECT_EQ(game.record().status, Status::kVoid);
  EXPECT_NE(game.record().void_reason.find("game-controller"), std::string::npos);
}

TEST(CommandedGame, ShowsTheGivenSignalAndNotItsReferees) {
  Game game(commanded_game());
  game.follow(given(CommandKind::kStop, 1));
  for (int i = 0; i < 300; ++i) ASSERT_TRUE(game.step());
  EXPECT_EQ(game.signal().command, (Command{CommandKind::kStop, Side::kWest}));
  EXPECT_EQ(game.signal().command_counter, 1U);
}

TEST(CommandedGame, NotesAnEventOfItsRefereeForEachCommandGiven) {
  Game game(commanded_game());
  game.follow(given(CommandKind::kStop, 1));
  ASSERT_TRUE(game.step());
  game.follow(given(CommandKind::kForceStart, 2));
  ASSERT_TRUE(game.step());
  game.follow(given(CommandKind::kForceStart, 2));
  EXPECT_EQ(game.record().count(referee::Event::kCommandGiven), 2);
}

TEST(CommandedGame, ChainsBeginWithTheGivenRestarts) {
  struct Starts final : Observer {
    void on_chain(const PossessionChain& chain) override { starts.push_back(chain.start); }
    std::vector<ChainStart> starts;
  } starts;
  Game game(commanded_game(), &starts);
  RefereeSignal signal = given(CommandKind::kPrepareKickoff, 1);
  signal.placement = Placement{};
  const auto play = [&](int frames) {
    game.follow(signal);
    for (int i = 0; i < frames && starts.starts.empty(); ++i) ASSERT_TRUE(game.step());
  };
  play(300);
  signal = given(CommandKind::kNormalStart, 2);
  signal.stage = Stage::kFirstHalf;
  play(1200);
  ASSERT_FALSE(starts.starts.empty());
  EXPECT_EQ(starts.starts.front(), ChainStart::kKickOff);
}

TEST(CommandedGame, CountsTheGivenGoals) {
  Game game(commanded_game());
  game.follow(given(CommandKind::kStop, 1));
  ASSERT_TRUE(game.step());
  RefereeSignal signal = given(CommandKind::kStop, 1);
  signal.goals[Side::kWest] = 2;
  game.follow(signal);
  EXPECT_EQ(game.record().goals_a, 2);
}

TEST(CommandedGame, MayTakeLongerSinceTheControllersClockStops) {
  referee::Match match = commanded_game().match;
  const double commanded_s = longest_s(match);
  match.control = referee::Control::kAutoref;
  EXPECT_GT(commanded_s, longest_s(match) + match.halves * match.half_s);
}

TEST(CommandedGame, IsOverAfterTheGame) {
  Game game(commanded_game());
  game.follow(given(CommandKind::kStop, 1));
  ASSERT_TRUE(game.step());
  RefereeSignal signal = given(CommandKind::kHalt, 2);
  signal.stage = Stage::kPostGame;
  game.follow(signal);
  EXPECT_TRUE(game.is_over());
  EXPECT_EQ(game.record().status, Status::kOk);
}

}  // namespace
}  // namespace autoref::game
