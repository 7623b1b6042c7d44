#include "runner/batch/rehearsal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "runner/batch/experiment_kinds.hpp"
#include "tests/runner/batch/fake_games.hpp"

namespace autoref::runner {
namespace {

using std::chrono::duration;

constexpr double kAmple_s = 3600;  // for games of milliseconds, however busy the machine is

// Rehearses games in workers. Each game appends its number of robots and its half length to a file.
class Rehearse : public testing::Test {
 protected:
  std::vector<Rehearsal> rehearsed(const Scenario& scenario, RehearsalOptions options) const {
    options.play = [this, play = options.play](const GameConfiguration& game) {
      write_content(folder_ / "games",
                    fmt::format("{} {}\n", game.b.robots.size(), game.match.half_s), std::ios::app);
      return play(game);
    };
    return rehearse(scheduled_games(scenario), options);
  }
  std::string games() const { return content_of(folder_ / "games"); }

  TemporaryFolder folder_;
};

TEST_F(Rehearse, PlaysAFewSecondsOfEachCombinationFirst) {
  const std::vector<Rehearsal> rehearsals = rehearsed(small_sweep(3), {fake_game});
  EXPECT_TRUE(games().starts_with("6 5\n5 5\n")) << games();
  ASSERT_EQ(rehearsals.size(), 2U);
  EXPECT_EQ(rehearsals[1].played, "b.robots=5");
  EXPECT_EQ(rehearsals[1].games, 6);
  EXPECT_EQ(rehearsals[1].void_reason, "");
}

TEST_F(Rehearse, PlaysWholeGamesIfThereIsTime) {
  rehearsed(small_sweep(1), {fake_game, 1, kAmple_s});
  EXPECT_TRUE(games().ends_with("6 600\n5 600\n6 600\n5 600\n")) << games();
}

TEST_F(Rehearse, PlaysNoLongerHalvesThanTheGame) {
  Scenario scenario = small_sweep(1);
  std::get<Sweep>(scenario.content).base.match.half_s = 2;
  rehearsed(scenario, {fake_game});
  EXPECT_TRUE(games().starts_with("6 2\n5 2\n")) << games();
  EXPECT_EQ(games().find("5 5\n"), std::string::npos) << games();
}

// The first 10 s of the game take no wall time, the other 1190 s take 0.1 ms per second.
GameRecord play_with_a_cheap_start(const GameConfiguration& game) {
  const double middle_s = std::max(0.0, game.match.half_s * game.match.halves - 10);
  std::this_thread::sleep_for(duration<double>(1e-4 * middle_s));
  return fake_game(game);
}

// Six games of each of two combinations, one after the other: their times fit into the rehearsal's.
TEST_F(Rehearse, TakesTheMiddleOfAGameIntoAccount) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Rehearsal> rehearsals =
      rehearsed(small_sweep(3), {play_with_a_cheap_start, 1, kAmple_s});
  const duration<double> all = std::chrono::steady_clock::now() - start;
  ASSERT_EQ(rehearsals.size(), 2U);
  for (const Rehearsal& rehearsal : rehearsals) EXPECT_GT(rehearsal.wall_s_a_game, 0.118);
  EXPECT_LT(6 * (rehearsals[0].wall_s_a_game + rehearsals[1].wall_s_a_game), all.count());
}

// A game takes 6 s, so only a part of it fits into the rehearsal.
TEST_F(Rehearse, PlaysALongerPartIfThereIsNoTimeForAWholeGame) {
  const auto play = [](const GameConfiguration& game) {
    std::this_thread::sleep_for(duration<double>(game.match.half_s / 100));
    return fake_game(game);
  };
  const std::vector<Rehearsal> rehearsals = rehearsed(small_sweep(1), {play, 1, 4.5});
  const std::string all = games();
  EXPECT_EQ(all.find(" 600\n"), std::string::npos) << all;
  EXPECT_EQ(line_count(all), 4) << all;
  const double longer_half_s = std::stod(all.substr(all.rfind(' ')));
  EXPECT_GT(longer_half_s, 10) << all;
  EXPECT_GT(rehearsals[0].wall_s_a_game, longer_half_s / 100);
}

TEST(WholeGame, IsExtrapolatedFromItsFirstSeconds) {
  EXPECT_DOUBLE_EQ(whole_game_s({{0.01, 0.03}}), 3);
}

// 0.5 s for the start, and 2 s for the rest of the game.
TEST(WholeGame, IsExtrapolatedFromTheMeanOfLongerParts) {
  EXPECT_DOUBLE_EQ(whole_game_s({{0, 0.5}, {0.25, 0.9}, {0.25, 1.1}}), 2.5);
}

TEST(WholeGame, IsTheMeanOfWholeGamesIfTheyWerePlayed) {
  EXPECT_DOUBLE_EQ(whole_game_s({{0.01, 1}, {1, 3}, {1, 5}}), 4);
}

TEST(WholeGame, TakesNoLessTimeThanALongerPart) {
  EXPECT_DOUBLE_EQ(whole_game_s({{0.01, 2}, {0.5, 1}}), 1);
}

TEST_F(Rehearse, EndsInTime) {
  Scenario scenario = small_sweep(1);
  std::get<Sweep>(scenario.content).factors = {{"sim.vision.ball_noise_m", {}}};
  for (int i = 0; i < 100; ++i) {
    std::get<Sweep>(scenario.content).factors[0].values.emplace_back(i / 1000.0);
  }
  const auto play = [](const GameConfiguration& game) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return fake_game(game);
  };
  const std::vector<Rehearsal> rehearsals = rehearsed(scenario, {play, 1, 4});
  EXPECT_TRUE(rehearsals.front().was_tried);
  EXPECT_FALSE(rehearsals.back().was_tried);
  EXPECT_GT(rehearsals.back().wall_s_a_game, 0);
}

TEST_F(Rehearse, EndsAGameThatHangs) {
  const auto play = [](const GameConfiguration& game) {
    if (game.b.robots.size() == 5) std::this_thread::sleep_for(std::chrono::minutes(2));
    return fake_game(game);
  };
  const std::vector<Rehearsal> rehearsals = rehearsed(small_sweep(1), {play, 1, 1});
  EXPECT_EQ(rehearsals[1].void_reason.find("it took longer than "), 0U);
}

TEST_F(Rehearse, ReportsWhyAGameIsVoid) {
  const auto play = [](const GameConfiguration& game) {
    if (game.b.robots.size() == 6) throw std::runtime_error("no such thing");
    GameRecord record = fake_game(game);
    record.void_reason = "a threw";
    return record;
  };
  const std::vector<Rehearsal> rehearsals = rehearsed(small_sweep(1), {play});
  EXPECT_EQ(rehearsals[0].void_reason, "no such thing");
  EXPECT_EQ(rehearsals[1].void_reason, "a threw");
}

TEST_F(Rehearse, ReportsAGameThatCrashesInTheMiddle) {
  const auto play = [](const GameConfiguration& game) {
    if (game.match.half_s > 100) std::abort();
    return fake_game(game);
  };
  const std::vector<Rehearsal> rehearsals = rehearsed(small_sweep(1), {play, 1, kAmple_s});
  EXPECT_NE(rehearsals[0].void_reason.find("signal 6 (Aborted)"), std::string::npos);
}

// With two workers, 10 games of 2 s end after 10 s; then each worker has three games of 4 s.
TEST(RehearsedDuration, SharesTheGamesBetweenTheWorkers) {
  const std::vector<Rehearsal> rehearsals = {{"x", 10, "", 2.0}, {"y", 6, "", 4.0}};
  EXPECT_DOUBLE_EQ(duration_s(rehearsals, 1), 44);
  EXPECT_DOUBLE_EQ(duration_s(rehearsals, 2), 22);
}

TEST(RehearsedDuration, IsThatOfTheLastWorker) {
  EXPECT_DOUBLE_EQ(duration_s({{"x", 5, "", 2.0}}, 2), 6);
}

}  // namespace
}  // namespace autoref::runner
