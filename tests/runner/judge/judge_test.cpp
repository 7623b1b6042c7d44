// Judging a referee over games: tallies, reports and reproducibility.
#include <gtest/gtest.h>

#include "runner/experiments/reading/scenario_reader.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/io/errors.hpp"
#include "runner/judge/judge_report.hpp"
#include "runner/judge/judged_rows.hpp"
#include "runner/results/evaluation_text.hpp"
#include "runner/results/row_format.hpp"
#include "runner/settings/resolved.hpp"

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

TEST(Quantile, IsTheSmallestValueNotExceededByTheShare) {
  EXPECT_EQ(quantile({3, 1, 2, 4}, 0.5), 2);
  EXPECT_EQ(quantile({3, 1, 2, 4}, 0.95), 4);
  EXPECT_FALSE(quantile({}, 0.5));
}

TEST(JudgeSchedule, PlaysTheSameSeedsWithEachCameraAndChangesSides) {
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
  const CallEvaluation evaluation =
      evaluate_calls(resolved(games_of(schedule())[1].configuration)).evaluation;
  EXPECT_FALSE(evaluation.verdicts.empty());
  EXPECT_EQ(text_of(evaluation_in(text_of(evaluation)).value()), text_of(evaluation));
}

TEST(CallEvaluation, IsRefusedIfTheTextIsNotOne) {
  for (const char* text : {"q,1\\n", "v,goal,9,,1.0,,0.0,\\n", "v,goal,0,,1.0,north,0.0,\\n",
                           "v,goal,0,,1.0,,0.0,x\\n", "t,a,1,2\\n", "t,a,1,2,x\\n", "t,c,1,2,3\\n"})
    EXPECT_FALSE(evaluation_in(text)) << text;
}

// Rows stored in files use these letters and numbers.
TEST(CallEvaluation, IsWrittenInAFixedForm) {
  CallEvaluation evaluation;
  ground_truth::Verdict missed = verdict(ground_truth::Outcome::kMissed);
  missed.time_s = 1.5;
  missed.offender = Side::kEast;
  missed.is_borderline = true;
  ground_truth::Verdict overtaken = verdict(ground_truth::Outcome::kOvertaken);
  overtaken.error_m = 0.25;
  evaluation.verdicts = {missed, overtaken};
  evaluation.last_touch[1].wrong = 2;
  EXPECT_EQ(text_of(evaluation),
            "v,goal,2,b,1.5000,east,0.0000,\\nv,goal,3,,0.0000,,0.0000,0.2500\\n"
            "t,a,0,0,0\\nt,b,0,2,0\\n");
}

TEST(JudgeReport, HasATableForEveryBookAndCamera) {
  const JudgeSchedule the_schedule = schedule();
  RowsById rows;
  for (const JudgeGame& one : games_of(the_schedule)) {
    const GameConfiguration game = resolved(one.configuration);
    GamePrograms programs = GamePrograms::live(game, {});
    play_judged(game, programs, rows[one.game_id]);
  }
  const std::string csv = csv_of(report_of(the_schedule, rows));
  EXPECT_NE(csv.find("\npaper,none,throw_in,"), std::string::npos) << csv;
}

TEST(JudgedRow, ReadsBackEqualWithAnyContent) {
  GameRow row;
  row.record.void_reason = "a \\n, \"b\"";
  row.record.transitions = {"begin", "goal"};
  row.evaluation.calls_in_stop = {"goal at 1.000 s", "a \\n, \"b\""};
  const RowFormat format({}, RowKind::kJudged);
  const std::string line = format.line(row);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(format.line(format.read(line).value()), line);
  EXPECT_EQ(format.read(line)->evaluation.calls_in_stop, row.evaluation.calls_in_stop);
}

TEST(JudgedRow, IsVoidIfItsEvaluationIsTooLong) {
  JudgedGame judged;
  judged.evaluation.calls_in_stop.assign(5000, "throw_in at 1234.567 s");
  GameRow row;
  keep(std::move(judged), row);
  EXPECT_EQ(row.record.status, Status::kVoid);
  EXPECT_TRUE(row.evaluation.calls_in_stop.empty());
  EXPECT_NE(row.record.void_reason.find("use shorter halves"), std::string::npos);
}

// In 40 games of 600 s with the camera `none`, only a few calls per thousand are wrong.
TEST(Judging, FindsThePapersRefereeMostlyRightWithExactVision) {
  GameConfiguration game;
  game.match.half_s = 120;
  game.seed = 11;
  CameraTally tally;
  const JudgedGame judged = evaluate_calls(game);
  tally.add(judged.record, judged.evaluation);
  ASSERT_GT(tally.events["throw_in"].happened(), 10);
  EXPECT_GE(tally.events["throw_in"].f1().value(), 0.9);
}

}  // namespace
}  // namespace autoref::runner
