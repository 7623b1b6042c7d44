#include "runner/batch/rehearsal.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "runner/batch/experiment_kinds.hpp"
#include "tests/runner/batch/fake_games.hpp"

namespace autoref::runner {
namespace {

TEST(Rehearse, PlaysOneGameOfEachCombination) {
  std::vector<int> robots;
  const auto play = [&robots](const GameConfiguration& game) {
    robots.push_back(game.b.robots);
    return fake_game(game);
  };
  const std::vector<Rehearsal> rehearsals = rehearse(scheduled_games(small_sweep(3)), play);
  EXPECT_EQ(robots, (std::vector<int>{6, 5}));
  ASSERT_EQ(rehearsals.size(), 2U);
  EXPECT_EQ(rehearsals[1].played, "b.robots=5");
  EXPECT_EQ(rehearsals[1].games, 6);
  EXPECT_EQ(rehearsals[1].void_reason, "");
}

TEST(Rehearse, PlaysShortHalvesAndNoLongerOnesThanTheGame) {
  Scenario scenario = small_sweep(1);
  std::vector<double> halves_s;
  const auto play = [&halves_s](const GameConfiguration& game) {
    halves_s.push_back(game.match.half_s);
    return fake_game(game);
  };
  rehearse(scheduled_games(scenario), play);
  std::get<Sweep>(scenario.content).base.match.half_s = 2;
  rehearse(scheduled_games(scenario), play);
  EXPECT_EQ(halves_s, (std::vector<double>{5, 5, 2, 2}));
}

TEST(Rehearse, SaysWhyAGameIsVoid) {
  const auto play = [](const GameConfiguration& game) {
    if (game.b.robots == 6) throw std::runtime_error("no such thing");
    GameRecord record = fake_game(game);
    record.void_reason = "a threw";
    return record;
  };
  const std::vector<Rehearsal> rehearsals = rehearse(scheduled_games(small_sweep(1)), play);
  EXPECT_EQ(rehearsals[0].void_reason, "no such thing");
  EXPECT_EQ(rehearsals[1].void_reason, "a threw");
}

TEST(Rehearse, SharesTheGamesBetweenTheWorkers) {
  const std::vector<Rehearsal> rehearsals = {{"x", 10, "", 2.0}, {"y", 5, "", 4.0}};
  EXPECT_DOUBLE_EQ(duration_s(rehearsals, 1), 40);
  EXPECT_DOUBLE_EQ(duration_s(rehearsals, 2), 20);
}

}  // namespace
}  // namespace autoref::runner
