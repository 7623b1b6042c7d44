// Judging a referee over games: tallies, reports and reproducibility.
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/results/call_evaluation.hpp"
#include "experiments/results/row_format.hpp"
#include "experiments/statistics/interval.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "judge/judge_report.hpp"
#include "judge/judge_tables.hpp"
#include "judge/judged_rows.hpp"

namespace autoref::judge {
namespace {

constexpr const char* kFile =
    "schema: 1\nkind: judge\nbase: { match: { half_s: 20 } }\n"
    "cameras: [none, realistic]\nmatchups: [basic~basic]\ngames: 2\nseed: 3\n";

experiments::JudgeSchedule schedule() {
  return *experiments::read_scenario_text(kFile, "x.yaml").as<experiments::JudgeSchedule>();
}

experiments::CallVerdict verdict(experiments::CallOutcome outcome) {
  experiments::CallVerdict verdict;
  verdict.name = "goal";
  verdict.outcome = outcome;
  return verdict;
}

TEST(EventTally, GivesPrecisionRecallAndTheLeaguesScore) {
  EventTally tally;
  for (int i = 0; i < 6; ++i) tally.add(verdict(experiments::CallOutcome::kRight));
  for (int i = 0; i < 2; ++i) tally.add(verdict(experiments::CallOutcome::kWrong));
  for (int i = 0; i < 4; ++i) tally.add(verdict(experiments::CallOutcome::kMissed));
  EXPECT_NEAR(tally.precision().value(), 0.75, 1e-9);
  EXPECT_NEAR(tally.recall().value(), 0.6, 1e-9);
  EXPECT_NEAR(tally.f1().value(), 2 * 0.75 * 0.6 / (0.75 + 0.6), 1e-9);
  EXPECT_EQ(tally.score(), 6 - 2 * 2);
}

TEST(EventTally, HasIntervals) {
  EventTally tally;
  tally.right = 57;
  tally.missed = tally.wrong = 3;
  const experiments::Interval wilson = experiments::wilson_interval(57, 60).value();
  for (const auto& interval : {tally.precision_interval(), tally.recall_interval()}) {
    EXPECT_EQ(interval->low, wilson.low);
    EXPECT_EQ(interval->high, wilson.high);
  }
  EXPECT_EQ(tally.f1_interval()->low, experiments::f1_interval(57, 3, 3)->low);
  EXPECT_FALSE(EventTally{}.f1_interval());
}

TEST(EventTally, IsRareBelowAHundredEvents) {
  EventTally tally;
  tally.right = 90;
  tally.missed = 9;
  tally.wrong = 50;  // wrong calls are not events
  EXPECT_TRUE(tally.is_rare());
  tally.missed = 10;
  EXPECT_FALSE(tally.is_rare());
}

// An early call has no event to be compared with.
TEST(EventTally, CountsCallsBeforeTheirEventUnlessTheyAreEarly) {
  EventTally tally;
  for (const double delay_s : {-0.0167, -0.0001, 0.0, 0.0167}) {
    experiments::CallVerdict right = verdict(experiments::CallOutcome::kRight);
    right.delay_s = delay_s;
    tally.add(right);
    right.is_early = true;
    tally.add(right);
  }
  EXPECT_EQ(tally.before, 2);
  EXPECT_EQ(tally.early, 4);
}

TEST(EventTally, AddsEverythingInAnother) {
  EventTally one;
  EventTally other;
  one.add(verdict(experiments::CallOutcome::kRight));
  other.add(verdict(experiments::CallOutcome::kRight));
  other.add(verdict(experiments::CallOutcome::kMissed));
  other.add(verdict(experiments::CallOutcome::kWrong));
  one.add(other);
  EXPECT_EQ(one.happened(), 3);
  EXPECT_EQ(one.calls(), 3);
  EXPECT_EQ(one.delays_s.size(), 2U);
}

TEST(TouchTally, CountsATouchOfTheWrongTeamAsMissedAndAsWrong) {
  const EventTally tally =
      touch_tally({experiments::LastTouchTally{5, 1, 2}, experiments::LastTouchTally{4, 0, 0}});
  EXPECT_EQ(tally.happened(), 12);
  EXPECT_EQ(tally.calls(), 10);
  EXPECT_EQ(tally.recall(), 9.0 / 12);
}

TEST(Quantile, IsTheSmallestValueNotExceededByTheShare) {
  EXPECT_EQ(quantile({3, 1, 2, 4}, 0.5), 2);
  EXPECT_EQ(quantile({3, 1, 2, 4}, 0.95), 4);
  EXPECT_FALSE(quantile({}, 0.5));
}

TEST(JudgeSchedule, PlaysTheSameSeedsWithEachCameraAndChangesSides) {
  const std::vector<experiments::ScheduledJudgeGame> games = experiments::games_of(schedule());
  ASSERT_EQ(games.size(), 4U);
  EXPECT_EQ(games[0].settings.combined().seed, games[1].settings.combined().seed);
  EXPECT_NE(games[0].camera, games[1].camera);
  EXPECT_EQ(games[0].settings.combined().match.a_plays, Side::kWest);
  EXPECT_EQ(games[2].settings.combined().match.a_plays, Side::kEast);
  EXPECT_EQ(games[0].settings.combined().match.half_s, 20);
}

TEST(JudgeSchedule, PlaysEveryGameWithEachNamedSeed) {
  experiments::JudgeSchedule two = schedule();
  two.cameras = {"none"};
  two.seeds = {{"tuning", "1", 1}, {"test", "2", 2}};
  const std::vector<experiments::ScheduledJudgeGame> games = experiments::games_of(two);
  ASSERT_EQ(games.size(), 4U);
  EXPECT_EQ(games[0].game_id, "tuning+paper+none+basic~basic-p0001-1");
  EXPECT_EQ(games[1].game_id, "test+paper+none+basic~basic-p0001-1");
  EXPECT_EQ(games[1].id, "test paper none basic~basic 1");
  EXPECT_NE(games[0].settings.combined().seed, games[1].settings.combined().seed);
}

TEST(JudgeSchedule, PlaysTheSameGamesIfOnlyOneSeedIsKept) {
  experiments::JudgeSchedule two = schedule();
  two.teams = {"rowdy", "basic", "zone"};
  two.seeds = {{"tuning", "1", 1}, {"test", "2", 2}};
  std::set<std::string> all;
  for (const experiments::ScheduledJudgeGame& game : experiments::games_of(two))
    all.insert(game.game_id);
  experiments::keep_seed(two, "test");
  const std::vector<experiments::ScheduledJudgeGame> games = experiments::games_of(two);
  EXPECT_EQ(games.size(), 4U);
  for (const experiments::ScheduledJudgeGame& game : games)
    EXPECT_TRUE(all.contains(game.game_id)) << game.game_id;
}

TEST(JudgeSchedule, RefusesToKeepAnUnknownSeed) {
  experiments::JudgeSchedule unnamed = schedule();
  EXPECT_THROW(experiments::keep_seed(unnamed, "test"), std::invalid_argument);
  unnamed.seeds = {{"tuning", "1", 1}};
  EXPECT_THROW(experiments::keep_seed(unnamed, "test"), std::invalid_argument);
}

// Games can be compared between cameras, since teams and seed are the same.
TEST(JudgeSchedule, DealsTheSameTeamsToEveryCamera) {
  experiments::JudgeSchedule dealt = schedule();
  dealt.teams = {"rowdy", "basic", "zone"};
  dealt.games_each = 12;
  const std::vector<experiments::ScheduledJudgeGame> games = experiments::games_of(dealt);
  std::set<std::string> matchups;
  for (std::size_t i = 0; i < games.size(); i += 2) {
    EXPECT_EQ(games[i].settings.combined().a.strategy, games[i + 1].settings.combined().a.strategy);
    EXPECT_EQ(games[i].settings.combined().b.strategy, games[i + 1].settings.combined().b.strategy);
    matchups.insert(games[i].settings.combined().a.strategy +
                    games[i].settings.combined().b.strategy);
  }
  EXPECT_EQ(matchups.size(), 6U);
}

TEST(JudgeSchedule, RefusesAMatchupOfUnknownTeams) {
  const std::string text =
      std::string(kFile).replace(std::string(kFile).find("basic~basic"), 11, "basic~bsaic");
  EXPECT_THROW(experiments::read_scenario_text(text, "x.yaml"), io::InputError);
}

TEST(JudgeSchedule, RefusesAnUnknownCamera) {
  EXPECT_THROW(experiments::read_scenario_text(
                   "schema: 1\nkind: judge\ncameras: [bad]\ngames: 2\nseed: 3\n", "x.yaml"),
               io::InputError);
}

TEST(CallEvaluation, ReadsBackEqualFromItsText) {
  const experiments::CallEvaluation evaluation =
      evaluate_calls(game::resolved(experiments::games_of(schedule())[1].settings.combined()))
          .evaluation;
  EXPECT_FALSE(evaluation.verdicts.empty());
  EXPECT_EQ(
      experiments::text_of(experiments::evaluation_in(experiments::text_of(evaluation)).value()),
      experiments::text_of(evaluation));
}

TEST(CallEvaluation, IsRefusedIfTheTextIsNotOne) {
  for (const char* text : {"q,1\\n", "v,goal,9,,1.0,,0.0,,\\n", "v,goal,0,,1.0,north,0.0,,\\n",
                           "v,goal,0,,1.0,,0.0,x,\\n", "v,goal,0,,1.0,,0.0,,x\\n", "t,a,1,2\\n",
                           "c,a,1,2,x\\n", "t,a,1,2,x\\n", "t,c,1,2,3\\n"})
    EXPECT_FALSE(experiments::evaluation_in(text)) << text;
}

// Rows stored in files use these letters and numbers.
TEST(CallEvaluation, IsWrittenInAFixedForm) {
  experiments::CallEvaluation evaluation;
  experiments::CallVerdict missed = verdict(experiments::CallOutcome::kMissed);
  missed.time_s = 1.5;
  missed.offender = Side::kEast;
  missed.is_borderline = true;
  experiments::CallVerdict overtaken = verdict(experiments::CallOutcome::kOvertaken);
  overtaken.error_m = 0.25;
  overtaken.confidence = 0.9;
  evaluation.verdicts = {missed, overtaken};
  evaluation.last_touch[1].wrong = 2;
  evaluation.contested_touch[1].wrong = 1;
  EXPECT_EQ(experiments::text_of(evaluation),
            "v,goal,2,b,1.5000,east,0.0000,,\\nv,goal,3,,0.0000,,0.0000,0.2500,0.9000\\n"
            "t,a,0,0,0\\nt,b,0,2,0\\nc,a,0,0,0\\nc,b,0,1,0\\n");
}

TEST(JudgeReport, HasATableForEveryBookAndCamera) {
  const experiments::JudgeSchedule the_schedule = schedule();
  experiments::RowsById rows;
  for (const experiments::ScheduledJudgeGame& one : experiments::games_of(the_schedule)) {
    const game::GameConfiguration game = game::resolved(one.settings.combined());
    game::GamePrograms programs = game::GamePrograms::live(game, {});
    play_judged(game, programs, rows[one.game_id]);
  }
  const std::string csv = csv_of(report_of(the_schedule, rows));
  EXPECT_NE(csv.find("\n,paper,none,throw_in,yes,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\n,paper,none,last_touch,yes,"), std::string::npos) << csv;
}

// Rows of two rule books with `goals` right calls of a goal each, and of a seed with a name.
JudgeReport report_on(const std::vector<int>& goals) {
  experiments::JudgeSchedule schedule;
  schedule.rules = {"paper", "2014"};
  schedule.cameras = {"none"};
  schedule.seeds = {{"test", "5", 5}};
  schedule.games_each = 1;
  experiments::RowsById rows;
  for (const experiments::ScheduledJudgeGame& game : experiments::games_of(schedule)) {
    const auto count = static_cast<std::size_t>(goals[rows.size()]);
    rows[game.game_id].evaluation.verdicts.assign(count, verdict(experiments::CallOutcome::kRight));
  }
  return report_of(schedule, rows);
}

TEST(JudgeReport, PoolsARareEventOverAllRuleBooks) {
  const std::string csv = csv_of(report_on({30, 120}));
  EXPECT_NE(csv.find("\ntest,paper,none,goal,yes,30,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\ntest,2014,none,goal,no,120,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\ntest,all,none,goal,no,150,"), std::string::npos) << csv;
}

TEST(JudgeReport, DoesNotPoolEventsOfASingleRuleBookNorFrequentOnes) {
  for (const std::vector<int>& goals : {std::vector<int>{30, 0}, {100, 120}}) {
    const std::string csv = csv_of(report_on(goals));
    EXPECT_EQ(csv.find(",all,none,goal,"), std::string::npos) << csv;
  }
}

TEST(JudgeReport, ShowsEveryScoreWithItsIntervalAndMarksRareOnes) {
  const std::string markdown = scores_markdown_of(report_on({30, 120}));
  EXPECT_NE(markdown.find("| goal | paper | test | 1.000 [0.886, 1.000] of 30 rare |"),
            std::string::npos)
      << markdown;
}

TEST(JudgeReport, BeginsWithASummaryOfTheLastSeedOverAllRuleBooks) {
  const std::string markdown = markdown_of(report_on({30, 120}));
  EXPECT_TRUE(markdown.starts_with("seeds: test 5\n\n| summary of test | none |\n"));
  EXPECT_NE(markdown.find("\n| goal | 1.000 [0.975, 1.000] of 150 |\n"), std::string::npos)
      << markdown;
}

TEST(JudgeReport, SummarisesNoOtherSeedThanTheLast) {
  JudgeReport report;
  for (const std::string seeds : {"tuning", "test"}) {
    CameraTally tally;
    tally.seeds = seeds;
    tally.rules = "paper";
    tally.camera = "none";
    tally.games = 1;
    tally.last_touch[0] = {seeds == "test" ? 3 : 4, 1, 0};
    report.tallies.push_back(tally);
  }
  EXPECT_EQ(summary_table(report).rows[1],
            (std::vector<std::string>{"last touch at exits", "75.0 % [30.1, 95.4] of 4 rare"}));
}

TEST(JudgeReport, NamesItsSeeds) {
  EXPECT_TRUE(markdown_of(report_on({1, 1})).starts_with("seeds: test 5\n"));
}

TEST(JudgeReport, ListsCallsBeforeTheirEvents) {
  experiments::JudgeSchedule schedule;
  schedule.cameras = {"none"};
  schedule.games_each = 1;
  const experiments::ScheduledJudgeGame game = experiments::games_of(schedule).front();
  experiments::CallVerdict right = verdict(experiments::CallOutcome::kRight);
  right.time_s = 2;
  right.delay_s = -0.016;
  experiments::RowsById rows;
  rows[game.game_id].evaluation.verdicts = {right};
  const std::vector<std::string> expected = {game.id + ": goal at 1.984 s, 16 ms before the event"};
  EXPECT_EQ(report_of(schedule, rows).calls_before_events, expected);
}

TEST(JudgedRow, ReadsBackEqualWithAnyContent) {
  experiments::GameRow row;
  row.record.void_reason = "a \\n, \"b\"";
  row.record.transitions = {"begin", "goal"};
  row.evaluation.calls_in_stop = {"goal at 1.000 s", "a \\n, \"b\""};
  const experiments::RowFormat format({}, experiments::RowKind::kJudged);
  const std::string line = format.line(row);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(format.line(format.read(line).value()), line);
  EXPECT_EQ(format.read(line)->evaluation.calls_in_stop, row.evaluation.calls_in_stop);
}

TEST(JudgedRow, IsVoidIfItsEvaluationIsTooLong) {
  EvaluatedGame judged;
  judged.evaluation.calls_in_stop.assign(5000, "throw_in at 1234.567 s");
  experiments::GameRow row;
  keep(std::move(judged), row);
  EXPECT_EQ(row.record.status, game::Status::kVoid);
  EXPECT_TRUE(row.evaluation.calls_in_stop.empty());
  EXPECT_NE(row.record.void_reason.find("use shorter halves"), std::string::npos);
}

// In 40 games of 600 s with the camera `none`, only a few calls per thousand are wrong.
TEST(Judging, FindsThePapersRefereeMostlyRightWithExactVision) {
  game::GameConfiguration game;
  game.match.half_s = 240;
  game.seed = 11;
  CameraTally tally;
  const EvaluatedGame judged = evaluate_calls(game);
  tally.add(judged.record, judged.evaluation);
  ASSERT_GT(tally.events["throw_in"].happened(), 10);
  EXPECT_GE(tally.events["throw_in"].f1().value(), 0.9);
}

}  // namespace
}  // namespace autoref::judge
