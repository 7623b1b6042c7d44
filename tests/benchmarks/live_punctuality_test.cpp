#include "benchmarks/live_punctuality.hpp"

#include <gtest/gtest.h>

#include "benchmarks/beside_live_game.hpp"

namespace autoref::benchmarks {
namespace {

TEST(LivePunctuality, LosesNoFrameOfEitherGame) {
  const std::vector<MeasuredLiveGame> games = measure_live_games({.seconds = 1});
  ASSERT_EQ(games.size(), 2U);
  for (const MeasuredLiveGame& game : games) {
    EXPECT_GT(game.game.frames, 0) << game.teams;
    EXPECT_GT(game.bare.frames, 0) << game.teams;
    EXPECT_GT(game.received, game.game.frames) << game.teams;
    EXPECT_EQ(game.lost, 0) << game.teams;
  }
}

TEST(LivePunctuality, TheRatioIsThatOfTheSharesOfLateFrames) {
  MeasuredLiveGame game;
  game.game = {.frames = 1000, .late = 12};
  game.bare = {.frames = 500, .late = 5};
  EXPECT_DOUBLE_EQ(*game.ratio(), 1.2);
  game.bare.late = 0;
  EXPECT_FALSE(game.ratio());
}

TEST(FrameCounter, CountsTheFramesThatAreMissing) {
  live::NetworkThread thread;
  FrameCounter counter(thread, [](std::string_view bytes) -> std::optional<std::int64_t> {
    return std::stoi(std::string(bytes));
  });
  live::DatagramSender sender(live::kLoopback, {live::kLoopback, counter.port()});
  for (const char* number : {"0", "1", "4"}) sender.send(number);
  while (counter.received() < 3) std::this_thread::yield();
  EXPECT_EQ(counter.lost(), 2);
}

}  // namespace
}  // namespace autoref::benchmarks
