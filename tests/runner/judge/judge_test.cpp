// Judging a referee over games: tallies, reports, and that all of it is reproducible.
#include <gtest/gtest.h>

#include "runner/experiments/reading/scenario_reader.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/io/errors.hpp"
#include "runner/judge/judge_games.hpp"
#include "runner/judge/judge_report.hpp"

namespace autoref::runner {
namespace {

constexpr const char* kFile =
    "schema: 1\nkind: judge\nbase: { match: { half_s: 20 } }\n"
    "cameras: [none, realistic]\nmatchups: [basic~basic]\ngames: 2\nseed: 3\n";

JudgeSchedule schedule() {
  return std::get<JudgeSchedule>(read_scenario_text(kFile, "x.yaml").content);
}

ground_truth::Verdict verdict(ground_truth::Outcome outcome) {
  ground_truth::Verdict verdict;
  verdict.name = "goal";
  verdict.outcome = outcome;
  return verdict;
}

TEST(EventTally, GivesPrecisionRecallAndTheLeaguesScore) {
  EventTally tally;
  for (int i = 0; i < 6; ++i) tally.add(verdict(ground_truth::Outcome::kRight));
  for (int i = 0; i < 2; ++i) tally.add(verdict(ground_truth::Outcome::kWrong));
  for (int i = 0; i < 4; ++i) tally.add(verdict(ground_truth::Outcome::kMissed));
  EXPECT_NEAR(tally.precision().value(), 0.75, 1e-9);
  EXPECT_NEAR(tally.recall().value(), 0.6, 1e-9);
  EXPECT_NEAR(tally.f1().value(), 2 * 0.75 * 0.6 / (0.75 + 0.6), 1e-9);
  EXPECT_EQ(tally.score(), 6 - 2 * 2);
}

TEST(Quantile, IsTheSmallestValueThatTheShareDoesNotExceed) {
  EXPECT_EQ(quantile({3, 1, 2, 4}, 0.5), 2);
  EXPECT_EQ(quantile({3, 1, 2, 4}, 0.95), 4);
  EXPECT_FALSE(quantile({}, 0.5));
}

TEST(JudgeSchedule, PlaysTheSameSeedsUnderEachCameraAndChangesEnds) {
  const std::vector<JudgeGame> games = games_of(schedule());
  ASSERT_EQ(games.size(), 4U);
  EXPECT_EQ(games[0].configuration.seed, games[1].configuration.seed);
  EXPECT_NE(games[0].camera, games[1].camera);
  EXPECT_EQ(games[0].configuration.match.a_plays, Side::kWest);
  EXPECT_EQ(games[2].configuration.match.a_plays, Side::kEast);
  EXPECT_EQ(games[0].configuration.match.half_s, 20);
}

TEST(JudgeSchedule, RefusesAMatchupOfUnknownTeams) {
  const std::string text =
      std::string(kFile).replace(std::string(kFile).find("basic~basic"), 11, "basic~bsaic");
  EXPECT_THROW(read_scenario_text(text, "x.yaml"), InputError);
}

TEST(JudgeSchedule, RefusesAnUnknownCamera) {
  EXPECT_THROW(
      read_scenario_text("schema: 1\nkind: judge\ncameras: [bad]\ngames: 2\nseed: 3\n", "x.yaml"),
      InputError);
}

TEST(CallEvaluation, ReadsBackEqualFromItsText) {
  const CallEvaluation evaluation = evaluate_calls(games_of(schedule())[1].configuration);
  EXPECT_FALSE(evaluation.verdicts.empty());
  EXPECT_EQ(text_of(evaluation_in(text_of(evaluation))), text_of(evaluation));
  EXPECT_THROW(evaluation_in("q,1\n"), std::invalid_argument);
}

TEST(Judging, ComesOutTheSameOnAnyNumberOfWorkers) {
  const JudgeSchedule the_schedule = schedule();
  const std::vector<JudgeGame> games = games_of(the_schedule);
  const std::string one = csv_of(report_of(the_schedule, judge_games(games, 1, nullptr)));
  EXPECT_EQ(csv_of(report_of(the_schedule, judge_games(games, 3, nullptr))), one);
  EXPECT_NE(one.find("\npaper,none,throw_in,"), std::string::npos) << one;
}

// Over 40 games of 600 s under camera `none` the referee is right at all but a few in a thousand.
TEST(Judging, FindsThePapersRefereeRightMostOfTheTimeWhereVisionIsExact) {
  GameConfiguration game;
  game.match.half_s = 120;
  game.seed = 11;
  CameraTally tally;
  tally.add(evaluate_calls(game));
  ASSERT_GT(tally.events["throw_in"].happened(), 10);
  EXPECT_GE(tally.events["throw_in"].f1().value(), 0.9);
}

}  // namespace
}  // namespace autoref::runner
