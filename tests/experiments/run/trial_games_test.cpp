#include "experiments/run/trial_games.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>

#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

using std::chrono::duration;

constexpr double kAmple_s = 3600;  // for games of milliseconds, however busy the machine is

// A trial with fake games.
struct FakeTrial {
  std::function<game::GameRecord(const game::GameConfiguration&)> play;
  int workers = 1;
  double longest_s = TrialOptions{}.longest_s;
};

// Plays trial games in workers. Each game appends its number of robots and its half length to a
// file.
class TrialGames : public testing::Test {
 protected:
  std::vector<Trial> trials_of(const Scenario& scenario, const FakeTrial& fake) const {
    const auto play = [this, &fake](const game::GameConfiguration& game, double /*most_wall_s*/) {
      write_content(folder_ / "games",
                    fmt::format("{} {}\n", game.b.robots.size(), game.match.half_s), std::ios::app);
      return PlayedPart{.void_reason = fake.play(game).void_reason};
    };
    return play_trials(scenario.experiment().games(), {play, fake.workers, fake.longest_s});
  }
  std::string games() const { return content_of(folder_ / "games"); }

  TemporaryFolder folder_;
};

TEST_F(TrialGames, PlaysAFewSecondsOfEachCombinationFirst) {
  const std::vector<Trial> trials = trials_of(small_sweep(3), {fake_game});
  EXPECT_TRUE(games().starts_with("6 5\n5 5\n")) << games();
  ASSERT_EQ(trials.size(), 2U);
  EXPECT_EQ(trials[1].played, "b.robots=5");
  EXPECT_EQ(trials[1].games, 6);
  EXPECT_EQ(trials[1].void_reason, "");
}

TEST_F(TrialGames, PlaysWholeGamesIfThereIsTime) {
  trials_of(small_sweep(1), {fake_game, 1, kAmple_s});
  EXPECT_TRUE(games().ends_with("6 600\n5 600\n6 600\n5 600\n")) << games();
}

TEST_F(TrialGames, PlaysNoLongerHalvesThanTheGame) {
  Scenario scenario = small_sweep(1);
  scenario.as<Sweep>()->base.match.half_s = 2;
  trials_of(scenario, {fake_game});
  EXPECT_TRUE(games().starts_with("6 2\n5 2\n")) << games();
  EXPECT_EQ(games().find("5 5\n"), std::string::npos) << games();
}

// The first 10 s of the game take no wall time, the other 1190 s take 0.1 ms per second.
game::GameRecord play_with_a_cheap_start(const game::GameConfiguration& game) {
  const double middle_s = std::max(0.0, game.match.half_s * game.match.halves - 10);
  std::this_thread::sleep_for(duration<double>(1e-4 * middle_s));
  return fake_game(game);
}

// Six games of each of two combinations, one after the other: their times fit into the trial's.
TEST_F(TrialGames, TakesTheMiddleOfAGameIntoAccount) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Trial> trials =
      trials_of(small_sweep(3), {play_with_a_cheap_start, 1, kAmple_s});
  const duration<double> all = std::chrono::steady_clock::now() - start;
  ASSERT_EQ(trials.size(), 2U);
  for (const Trial& trial : trials) EXPECT_GT(trial.wall_s_a_game, 0.118);
  EXPECT_LT(6 * (trials[0].wall_s_a_game + trials[1].wall_s_a_game), all.count());
}

// A game takes 6 s, so only a part of it fits into the trial.
TEST_F(TrialGames, PlaysALongerPartIfThereIsNoTimeForAWholeGame) {
  const auto play = [](const game::GameConfiguration& game) {
    std::this_thread::sleep_for(duration<double>(game.match.half_s / 100));
    return fake_game(game);
  };
  const std::vector<Trial> trials = trials_of(small_sweep(1), {play, 1, 4.5});
  const std::string all = games();
  EXPECT_EQ(all.find(" 600\n"), std::string::npos) << all;
  EXPECT_EQ(line_count(all), 4) << all;
  const double longer_half_s = std::stod(all.substr(all.rfind(' ')));
  EXPECT_GT(longer_half_s, 10) << all;
  EXPECT_GT(trials[0].wall_s_a_game, longer_half_s / 100);
}

// A second of the game takes 0.1 s, its 5 s per half 1 s: in 2 s, 10 variants can only be tried if
// each stops early.
PlayedPart play_slowly(const game::GameConfiguration& game, double most_wall_s) {
  const double whole_s = 0.1 * game.match.half_s * game.match.halves;
  const double wall_s = std::min(whole_s, most_wall_s);
  std::this_thread::sleep_for(duration<double>(wall_s));
  return {.share = wall_s / whole_s};
}

Scenario sweep_of_ten() {
  Scenario scenario = small_sweep(1);
  auto& sweep = *scenario.as<Sweep>();
  sweep.factors = {{"sim.vision.ball_noise_m", {}}};
  for (int i = 0; i < 10; ++i) sweep.factors[0].values.emplace_back(i / 1000.0);
  return scenario;
}

TEST(SlowTrialGames, TriesEveryVariantForAShareOfTheTime) {
  const std::vector<Trial> trials =
      play_trials(sweep_of_ten().experiment().games(), {play_slowly, 1, 4});
  ASSERT_EQ(trials.size(), 10U);
  for (const Trial& trial : trials) {
    EXPECT_TRUE(trial.was_tried) << trial.played;
    EXPECT_LT(trial.share, 0.01);
    EXPECT_GT(trial.wall_s_a_game, 119);
  }
}

TEST_F(TrialGames, ReportsWhatShareOfAGameItsEstimateIsFrom) {
  const auto play = [](const game::GameConfiguration& game, double /*most_wall_s*/) {
    return PlayedPart{.share = game.match.half_s > 100 ? 0.25 : 1};
  };
  const std::vector<Trial> trials =
      play_trials(small_sweep(1).experiment().games(), {play, 1, kAmple_s});
  EXPECT_DOUBLE_EQ(trials[0].share, 0.25);
}

TEST(EstimatedGame, StartsOnlyOnce) {
  EXPECT_NEAR(estimated_game_s({{0.01, 0.53, 0.5}}), 3.5, 1e-9);
}

Scenario roundrobin_with_a_program() {
  Scenario scenario = small_roundrobin({6, 6}, 1);
  scenario.as<RoundRobin>()->teams["team1"].program.command = {"true"};
  return scenario;
}

// The part played takes 0.2 s, of which the program takes three quarters.
TEST(TrialGamesOfPrograms, SplitsTheTimeBetweenTheTeams) {
  const auto play = [](const game::GameConfiguration&, double /*most_wall_s*/) {
    std::this_thread::sleep_for(duration<double>(0.2));
    return PlayedPart{.team_s = {0.02, 0.15}};
  };
  const std::vector<Trial> trials =
      play_trials(roundrobin_with_a_program().experiment().games(), {play, 1, 2});
  const auto& teams = trials.at(0).teams;
  EXPECT_EQ(teams[1].name, "team1");
  EXPECT_TRUE(teams[1].is_program);
  EXPECT_FALSE(teams[0].is_program);
  EXPECT_NEAR(teams[1].wall_s_a_game / trials[0].wall_s_a_game, 0.7, 0.15);
}

// A run starts programs again and plays the first 10 s of 1200 s again.
TEST(TrialGamesOfPrograms, IncludesTheirRepetition) {
  const auto play = [](const game::GameConfiguration&, double /*most_wall_s*/) {
    std::this_thread::sleep_for(duration<double>(0.2));
    return PlayedPart{.start_s = 0.1};
  };
  const auto with =
      play_trials(roundrobin_with_a_program().experiment().games(), {play, 1, kAmple_s});
  EXPECT_GT(with[0].wall_s_a_game, 0.3);
}

TEST(CostOfPrograms, NamesTheProgramsByTheirShareOfTheTime) {
  Trial one{"x", 10, "", 4.0};
  one.teams = {TrialTeam{"mine", true, 3.0}, TrialTeam{"basic", false, 0.5}};
  Trial other{"y", 10, "", 1.0};
  other.teams = {TrialTeam{"slow", true, 0.5}, TrialTeam{"basic", false, 0.5}};
  EXPECT_EQ(
      cost_of_programs({one, other}, 1),
      "of that, the teams' programs take: mine 30 s (60 %), slow 5 s (10 %); everything else takes "
      "about 15 s");
}

TEST(CostOfPrograms, IsNotMentionedWithoutPrograms) {
  EXPECT_EQ(cost_of_programs({{"x", 10, "", 4.0}}, 1), "");
}

TEST(EstimatedGame, IsExtrapolatedFromItsFirstSeconds) {
  EXPECT_DOUBLE_EQ(estimated_game_s({{0.01, 0.03}}), 3);
}

// 0.5 s for the start, and 2 s for the rest of the game.
TEST(EstimatedGame, IsExtrapolatedFromTheMeanOfLongerParts) {
  EXPECT_DOUBLE_EQ(estimated_game_s({{0, 0.5}, {0.25, 0.9}, {0.25, 1.1}}), 2.5);
}

TEST(EstimatedGame, IsTheMeanOfWholeGamesIfTheyWerePlayed) {
  EXPECT_DOUBLE_EQ(estimated_game_s({{0.01, 1}, {1, 3}, {1, 5}}), 4);
}

TEST(EstimatedGame, TakesNoLessTimeThanALongerPart) {
  EXPECT_DOUBLE_EQ(estimated_game_s({{0.01, 2}, {0.5, 1}}), 1);
}

TEST_F(TrialGames, EndsInTime) {
  Scenario scenario = small_sweep(1);
  scenario.as<Sweep>()->factors = {{"sim.vision.ball_noise_m", {}}};
  for (int i = 0; i < 100; ++i) {
    scenario.as<Sweep>()->factors[0].values.emplace_back(i / 1000.0);
  }
  const auto play = [](const game::GameConfiguration& game) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return fake_game(game);
  };
  const std::vector<Trial> trials = trials_of(scenario, {play, 1, 4});
  EXPECT_TRUE(trials.front().was_tried);
  EXPECT_FALSE(trials.back().was_tried);
  EXPECT_GT(trials.back().wall_s_a_game, 0);
}

TEST_F(TrialGames, EndsAGameThatHangs) {
  const auto play = [](const game::GameConfiguration& game) {
    if (game.b.robots.size() == 5) std::this_thread::sleep_for(std::chrono::minutes(2));
    return fake_game(game);
  };
  const std::vector<Trial> trials = trials_of(small_sweep(1), {play, 1, 1});
  EXPECT_EQ(trials[1].void_reason.find("it took longer than "), 0U);
}

TEST_F(TrialGames, ReportsWhyAGameIsVoid) {
  const auto play = [](const game::GameConfiguration& game) {
    if (game.b.robots.size() == 6) throw std::runtime_error("no such thing");
    game::GameRecord record = fake_game(game);
    record.void_reason = "a threw";
    return record;
  };
  const std::vector<Trial> trials = trials_of(small_sweep(1), {play});
  EXPECT_EQ(trials[0].void_reason, "no such thing");
  EXPECT_EQ(trials[1].void_reason, "a threw");
}

TEST_F(TrialGames, RemembersAVoidGameAfterGoodOnes) {
  const std::vector<Trial> trials =
      play_trials(small_sweep(1).experiment().games(),
                  {[this](const game::GameConfiguration& game, double /*most_wall_s*/) {
                     // Parts are played in workers, which share nothing but files.
                     const bool is_first_whole = game.match.half_s > 5 && games().empty();
                     if (is_first_whole) write_content(folder_ / "games", "void");
                     return PlayedPart{.void_reason = is_first_whole ? "a threw" : ""};
                   },
                   1, kAmple_s});
  ASSERT_EQ(trials.size(), 2U);
  EXPECT_EQ(trials[0].void_reason, "a threw");
  EXPECT_EQ(trials[1].void_reason, "");
}

TEST_F(TrialGames, ReportsAGameThatCrashesInTheMiddle) {
  const auto play = [](const game::GameConfiguration& game) {
    if (game.match.half_s > 100) std::abort();
    return fake_game(game);
  };
  const std::vector<Trial> trials = trials_of(small_sweep(1), {play, 1, kAmple_s});
  EXPECT_NE(trials[0].void_reason.find("signal 6 (Aborted)"), std::string::npos);
}

// With two workers, 10 games of 2 s end after 10 s; then each worker has three games of 4 s.
TEST(TrialDuration, SharesTheGamesBetweenTheWorkers) {
  const std::vector<Trial> trials = {{"x", 10, "", 2.0}, {"y", 6, "", 4.0}};
  EXPECT_DOUBLE_EQ(duration_s(trials, 1), 44);
  EXPECT_DOUBLE_EQ(duration_s(trials, 2), 22);
}

TEST(TrialDuration, IsThatOfTheLastWorker) {
  EXPECT_DOUBLE_EQ(duration_s({{"x", 5, "", 2.0}}, 2), 6);
}

}  // namespace
}  // namespace autoref::experiments
