// `kind: situations`: what is read, and what is refused.
#include <gtest/gtest.h>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/situations/situations.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"
#include "tests/experiments/reading/mistake.hpp"

namespace autoref::experiments {
namespace {

TEST(SituationsReader, ReadsNumbersAndDistributions) {
  const SituationSetup goal = situations_in(small_situations()).situations.at("goal");
  EXPECT_EQ(goal.ball.x_m, Distribution(2));
  EXPECT_EQ(goal.ball.y_m, Distribution::uniform(-0.1, 0.1));
  ASSERT_EQ(goal.attackers.size(), 2U);
  EXPECT_EQ(goal.attackers[1].number, 3);
  EXPECT_EQ(goal.defenders[0].y_m, Distribution::normal(-1, 0.2));
  EXPECT_EQ(goal.restart, Restart::kNone);
  EXPECT_EQ(goal.scene.lasts_s, 2);
}

TEST(SituationsReader, ReadsBackEqualFromTheEffectiveFile) {
  const Scenario scenario = small_situations();
  const std::string text = effective_text(scenario);
  const Scenario again = read_scenario_text(text, "effective.yaml");
  EXPECT_EQ(effective_text(again), text);
  EXPECT_EQ(changes_between(scenario.experiment(), again.experiment()), "");
}

// Lines 1 to 5, then those of one situation, which begin at line 6.
std::string situation_file(const std::string& lines, const std::string& top = "") {
  return "schema: 1\nkind: situations\n"
         "attackers: { one: { strategy: dummy } }\n"
         "defenders: { other: { strategy: dummy } }\n"
         "situations:\n" +
         lines + "pairs: 1\nseed: 1\n" + top;
}

std::string in_corner(const std::string& keys) {
  return situation_file("  corner: { ball: { x_m: 0, y_m: 0 }, " + keys + " }\n");
}

game::Scene scene_read_from(const std::string& keys) {
  const Scenario scenario = read_scenario_text(in_corner(keys), "x.yaml");
  return scenario.as<Situations>()->situations.at("corner").scene;
}

TEST(SituationsReader, ReadsAScoreAsOneMeasureOrAsWeights) {
  EXPECT_EQ(scene_read_from("score: ball_kept").weights, (game::SceneWeights{0, 0, 1, 0, 0}));
  EXPECT_EQ(scene_read_from("score: { goal: 1, conceded: -1, gained_m: 0.1, xg: 0.5 }").weights,
            (game::SceneWeights{1, -1, 0, 0.1, 0.5}));
  EXPECT_EQ(scene_read_from("lasts_s: 3").weights, game::SceneWeights{});
}

TEST(SituationsReader, ReadsWhatEndsAScene) {
  const game::Scene scene = scene_read_from("ends_on: [goal, foul]");
  EXPECT_TRUE(scene.is_ended_by(game::SceneEnd::kGoal));
  EXPECT_TRUE(scene.is_ended_by(game::SceneEnd::kFoul));
  EXPECT_TRUE(scene.is_ended_by(game::SceneEnd::kTime));
  EXPECT_FALSE(scene.is_ended_by(game::SceneEnd::kBallOut));
}

TEST(SituationsReader, PutsThePenaltyBallOnTheMark) {
  const Scenario scenario =
      read_scenario_text(situation_file("  penalty: { restart: penalty }\n"), "x.yaml");
  const SituationSetup& penalty = scenario.as<Situations>()->situations.at("penalty");
  EXPECT_EQ(penalty.ball.x_m.first, Field{}.penalty_mark_at(Side::kEast).x());
}

class SituationsMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SituationsMistake, IsRefused) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Keys, SituationsMistake,
    testing::Values(
        Mistake{"no_situations", situation_file("  {}\n"), "x.yaml:5:1", {"at least one"}},
        Mistake{"bad_name",
                situation_file("  a b: { ball: { x_m: 0, y_m: 0 } }\n"),
                "x.yaml:6:3",
                {"situation's name", "'a b'"}},
        Mistake{"no_ball",
                situation_file("  corner: { restart: direct_free }\n"),
                "x.yaml:6:3",
                {"situations.corner", "'ball' is missing"}},
        Mistake{"half_a_ball",
                situation_file("  corner: { ball: { x_m: 0 } }\n"),
                "x.yaml:6:13",
                {"situations.corner.ball", "'y_m' is missing"}},
        Mistake{"unknown_key",
                in_corner("balls: 1"),
                "x.yaml:6:",
                {"situations.corner", "'balls'", "did you mean 'ball'"}},
        Mistake{"unknown_restart",
                in_corner("restart: corner"),
                "x.yaml:6:",
                {"situations.corner.restart", "direct_free"}},
        Mistake{"unknown_score",
                in_corner("score: goals"),
                "x.yaml:6:",
                {"situations.corner.score", "did you mean 'goal'"}},
        Mistake{"no_weight",
                in_corner("score: { goal: 0 }"),
                "x.yaml:6:",
                {"situations.corner.score", "all weights are 0"}},
        Mistake{"unknown_end",
                in_corner("ends_on: [goal, time]"),
                "x.yaml:6:",
                {"situations.corner.ends_on", "'time'"}},
        Mistake{"stop_without_restart",
                in_corner("after_stop: true"),
                "x.yaml:6:",
                {"situations.corner.after_stop", "needs a restart"}},
        Mistake{"outside_the_walls",
                in_corner("attackers: { 1: { x_m: 9, y_m: 0 } }"),
                "x.yaml:6:",
                {"situations.corner.attackers.1.x_m", "'9'"}},
        Mistake{"reversed_ends",
                in_corner("attackers: { 1: { x_m: [2, 1], y_m: 0 } }"),
                "x.yaml:6:",
                {"situations.corner.attackers.1.x_m", "reversed"}},
        Mistake{"three_ends",
                in_corner("attackers: { 1: { x_m: [1, 2, 3], y_m: 0 } }"),
                "x.yaml:6:",
                {"situations.corner.attackers.1.x_m", "a list of 3"}},
        Mistake{"no_deviation",
                in_corner("attackers: { 1: { x_m: { mean: 1 }, y_m: 0 } }"),
                "x.yaml:6:",
                {"situations.corner.attackers.1.x_m", "'sd' is missing"}},
        Mistake{"no_number",
                in_corner("attackers: { first: { x_m: 1, y_m: 0 } }"),
                "x.yaml:6:",
                {"situations.corner.attackers", "'first'"}},
        Mistake{"robot_that_does_not_exist",
                in_corner("defenders: { 6: { x_m: 1, y_m: 0 } }"),
                "x.yaml:6:",
                {"situations.corner.defenders.6", "team 'other' has 6 robots"}},
        Mistake{"overlap",
                in_corner("defenders: { 1: { x_m: 1, y_m: 0 }, 2: { x_m: 1.1, y_m: 0 } }"),
                "x.yaml:6:3",
                {"situations.corner", "defenders.1 and defenders.2 overlap"}},
        Mistake{"no_log",
                situation_file("  corner: { from: { log: none.log, at_s: 1 } }\n"),
                "x.yaml:6:",
                {"situations.corner.from", "none.log"}},
        Mistake{"no_time",
                situation_file("  corner: { from: { log: none.log } }\n"),
                "x.yaml:6:",
                {"situations.corner.from", "'at_s' is missing"}},
        Mistake{"log_and_ball",
                in_corner("from: { log: none.log, at_s: 1 }"),
                "x.yaml:6:",
                {"situations.corner", "'ball'"}},
        Mistake{"base_with_teams",
                situation_file("  corner: { ball: { x_m: 0, y_m: 0 } }\n",
                               "base: { teams: { a: { robots: 5 } } }\n"),
                "x.yaml:9:",
                {"attackers"}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(SituationsReader, RefusesAssignmentsToTeamsAOrB) {
  const game::Assignments sets = game::assignments_in({"a.robots=5"});
  EXPECT_THROW(read_scenario_text(kSmallSituations, "x.yaml", sets), io::InputError);
}

TEST(SituationsReader, AppliesAssignmentsToNamedTeams) {
  const game::Assignments sets =
      game::assignments_in({"attackers.one.robots=5", "match.half_s=30"});
  const Situations situations = situations_in(read_scenario_text(kSmallSituations, "x.yaml", sets));
  EXPECT_EQ(situations.attackers.at("one").robots, 5);
  EXPECT_EQ(situations.attackers.at("two").robots, 6);
  EXPECT_EQ(situations.base.match.half_s, 30);
}

}  // namespace
}  // namespace autoref::experiments
