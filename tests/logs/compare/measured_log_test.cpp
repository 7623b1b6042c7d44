// What is measured in the log of a simulated game, against the game itself.
#include "logs/compare/measured_log.hpp"

#include <gtest/gtest.h>

#include "game/loop/game.hpp"
#include "game/loop/log_recorder.hpp"
#include "logs/compare/game_comparison.hpp"
#include "sim/presets.hpp"
#include "soccer/referee_signal.hpp"
#include "tests/league/scratch_log.hpp"
#include "tests/logs/sketched_log.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::logs {
namespace {

game::GameConfiguration game_to_measure(std::uint64_t seed) {
  game::GameConfiguration game = short_game_by("2026-b", 90, seed);
  game.match.halves = 1;
  game.a.strategy = "cobalt";
  game.b.strategy = "cobalt";
  sim::apply_camera_preset("rc2026-b", game.sim);
  return game;
}

class MeasuredLog : public testing::Test {
 protected:
  // Plays the game, and measures its log.
  MeasuredGames measured(const game::GameConfiguration& game) {
    const league::ScratchFile file(".log");
    game::LogRecorder recorder(file.path(), game);
    record_ = game::play(game, &recorder);
    recorder.close();
    return measured(file.path(), game);
  }

  MeasuredGames measured(const std::filesystem::path& log, game::GameConfiguration game) {
    game.match.control = referee::Control::kHuman;
    GamesMeasurer measurer;
    measurer.start_log();
    const LogRefereeResult result =
        referee_log(log, facts_of(log), {game::referee_configuration(game)}, {},
                    [&](const LogReferee& judged) { measurer.note(judged); });
    measurer.finish_log(log.string(), result.play);
    MeasuredGames games = measurer.finish();
    running_s_ = measurer.running_s();
    chains_ = result.play.chains.size();
    return games;
  }

  game::GameRecord record_;
  double running_s_ = 0;
  std::size_t chains_ = 0;
};

const MeasureCounts& counts_of(const AllCounts& all, Measure measure) {
  return all[static_cast<std::size_t>(measure)];
}

double share_of(const MeasureCounts& counts) {
  return static_cast<double>(counts.bins().back()) / static_cast<double>(counts.values());
}

TEST_F(MeasuredLog, AgreesWithTheGame) {
  const game::GameConfiguration game = game_to_measure(3);
  const AllCounts total = measured(game).total();
  EXPECT_GT(running_s_, 30);
  EXPECT_NEAR(counts_of(total, Measure::kStops).duration_s(), running_s_, 1e-6);
  EXPECT_GE(counts_of(total, Measure::kStops).values(), 1);
  // In play: while the clock runs, as a share of what the log shows of the half.
  const MeasureCounts& in_play = counts_of(total, Measure::kInPlay);
  const double seen_s = static_cast<double>(in_play.values()) / game.sim.frame_rate_hz;
  EXPECT_NEAR(share_of(in_play) * seen_s, record_.ball_in_play_s, 0.05 * record_.ball_in_play_s);
  EXPECT_EQ(counts_of(total, Measure::kPossession).values(), static_cast<std::int64_t>(chains_));

  const auto high = [&](Measure measure, double share) {
    return quantile_of(entry_of(measure), counts_of(total, measure), share);
  };
  EXPECT_NEAR(high(Measure::kRobotSpeed, 0.999), game.a.robots[0].body.speed_mps, 0.3);
  EXPECT_NEAR(high(Measure::kRobotAcceleration, 0.98), game.a.robots[0].body.acceleration_mps2,
              0.5);
  EXPECT_LT(high(Measure::kBallSpeed, 0.999), 7);
  EXPECT_GT(high(Measure::kBallSpeed, 0.999), 3);
  EXPECT_NEAR(high(Measure::kBallDeceleration, 0.25), game.sim.ball.roll_mps2, 0.1);
  EXPECT_GT(counts_of(total, Measure::kKickSpeed).values(), 5);
  EXPECT_GT(counts_of(total, Measure::kRollLength).values(), 10);
  EXPECT_NEAR(share_of(counts_of(total, Measure::kRobotUnseen)), 0.012, 0.004);
}

TEST_F(MeasuredLog, DistinguishesSlowRobotsFromFastOnesOnly) {
  game::GameConfiguration game = game_to_measure(3);
  const MeasuredGames normal = measured(game);
  game.seed = 4;
  const GameComparison alike = comparison_of(measured(game), normal);
  for (sim::TeamSpec::Robots* robots : {&game.a.robots, &game.b.robots})
    for (sim::RobotSpec& robot : *robots) robot.speed_factor = 0.5;
  const GameComparison slow = comparison_of(measured(game), normal);
  const auto distance = [](const GameComparison& comparison, Measure measure) {
    return comparison.measures.at(static_cast<std::size_t>(measure)).distance.value();
  };
  EXPECT_LT(distance(alike, Measure::kRobotSpeed).value, 0.15);
  EXPECT_GT(distance(slow, Measure::kRobotSpeed).low, 0.1);
  EXPECT_LT(distance(slow, Measure::kRobotUnseen).value, 0.02);
}

TEST_F(MeasuredLog, OfAGameIsAtDistanceZeroFromItself) {
  const MeasuredGames games = measured(game_to_measure(3));
  const GameComparison comparison = comparison_of(games, games);
  EXPECT_GE(comparison.compared, 10);
  for (const MeasureComparison& measure : comparison.measures)
    EXPECT_EQ(measure.distance.value_or(Distance{}).value, 0) << entry_of(measure.measure).name;
  ASSERT_TRUE(comparison.mean);
  EXPECT_EQ(comparison.mean->value, 0);
}

// A clip that was cut down to play does not show how often play stops.
TEST_F(MeasuredLog, DoesNotCountStopsIfPlayNeverStops) {
  SketchedLog sketch;
  sketch.change_referee = [](double /*time_s*/, league::RefereePacket& packet) {
    packet.set_command(league_number({CommandKind::kForceStart}));
  };
  const league::ScratchFile file(".log");
  write_sketch(sketch, file.path());
  const AllCounts total = measured(file.path(), short_game_by("2026-b", 90, 1)).total();
  EXPECT_GT(running_s_, 5);
  EXPECT_EQ(counts_of(total, Measure::kStops).duration_s(), 0);
  EXPECT_EQ(counts_of(total, Measure::kInPlay).values(), 0);
  EXPECT_GT(counts_of(total, Measure::kFouls).duration_s(), 5);
}

}  // namespace
}  // namespace autoref::logs
