// The win probability of running games.
#include "game/loop/win_probability_observer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "game/loop/game.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

struct Noted {
  double time_s = 0;
  WinProbability probability;
};

std::vector<Noted> noted_in(const GameConfiguration& game) {
  std::vector<Noted> noted;
  WinProbabilityObserver watch(game, [&noted](double time_s, const WinProbability& probability) {
    noted.push_back({time_s, probability});
  });
  play(game, &watch);
  return noted;
}

RefereeSignal signal_in(Stage stage, double left_s) {
  RefereeSignal signal;
  signal.stage = stage;
  signal.stage_time_left_s = left_s;
  return signal;
}

TEST(PlayingTime, IsThatOfTheRefereesClock) {
  referee::Match match;
  match.half_s = 300;
  match.rules.extra_half_s = 100;
  const auto expect = [&](Stage stage, double stage_s, double played_s, double left_s) {
    const PlayingTime time = playing_time(signal_in(stage, stage_s), match);
    EXPECT_DOUBLE_EQ(time.played_s, played_s) << name_of(stage);
    EXPECT_DOUBLE_EQ(time.left_s, left_s) << name_of(stage);
  };
  expect(Stage::kFirstHalfPre, 0, 0, 600);
  expect(Stage::kFirstHalf, 200, 100, 500);
  expect(Stage::kHalfTime, 0, 300, 300);
  expect(Stage::kSecondHalf, 50, 550, 50);
  expect(Stage::kSecondHalf, -2, 600, 0);
  expect(Stage::kExtraTimeBreak, 0, 600, 200);
  expect(Stage::kExtraFirstHalf, 30, 670, 130);
  expect(Stage::kExtraSecondHalf, 30, 770, 30);
  expect(Stage::kPostGame, 0, 600, 0);
  expect(Stage::kFirstHalf, 450, 0, 600);  // a controller with longer halves
}

TEST(WinProbabilityObserver, NotesTheProbabilityAtLeastEverySecond) {
  const GameConfiguration game = short_game_by("2026-b", 30, 3);
  const std::vector<Noted> noted = noted_in(game);
  ASSERT_GT(noted.size(), 50U);
  for (std::size_t i = 1; i < noted.size(); ++i) {
    const double passed_s = noted[i].time_s - noted[i - 1].time_s;
    EXPECT_GT(passed_s, 0);
    EXPECT_LE(passed_s, WinProbabilityObserver::kEvery_s + 1e-9);
  }
  for (const Noted& one : noted) {
    const auto& [west, draw, east] = one.probability;
    EXPECT_NEAR(west + draw + east, 1, 1e-9);
    EXPECT_GE(std::min({west, draw, east}), 0);
  }
}

// At the end of a game, the probability agrees with the result.
TEST(WinProbabilityObserver, EndsWithTheResult) {
  int decided = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const GameConfiguration game = short_game_by("2014", 60, seed);
    const GameRecord record = play(game);
    const WinProbability last = noted_in(game).back().probability;
    const int lead_of_a = record.goals_a - record.goals_b;
    const int lead = game.match.a_plays == Side::kWest ? lead_of_a : -lead_of_a;
    decided += lead == 0 ? 0 : 1;
    EXPECT_NEAR(last.share_of_west(), lead > 0 ? 1 : lead < 0 ? 0 : 0.5, 0.1) << seed;
  }
  EXPECT_GT(decided, 0);
}

// Watching does not change a game.
TEST(WinProbabilityObserver, DoesNotAffectTheGame) {
  const GameConfiguration game = short_game_by("2026-b", 20, 9);
  WinProbabilityObserver watch(game, [](double, const WinProbability&) {});
  EXPECT_EQ(play(game, &watch).state_hash, play(game).state_hash);
}

}  // namespace
}  // namespace autoref::game
