// What --set can and cannot change in scenarios.
#include <gtest/gtest.h>

#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "io/errors.hpp"

namespace autoref::experiments {
namespace {

std::string refusal_of_assignments(const std::string& lines,
                                   const game::Assignments& assignments = {}) {
  try {
    read_scenario_text("schema: 1\nkind: sweep\npairs: 1\nseed: 1\n" + lines, "x.yaml",
                       assignments);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Handicap, IsRefusedAsAFactorIfTheBaseSetsOneOfItsFactors) {
  EXPECT_EQ(refusal_of_assignments("base: { teams: { b: { speed_factor: 0.8 } } }\n"
                                   "factors: { b.handicap: [1.0, 0.5] }\n"),
            "x.yaml:6:12: b.handicap: 'base.teams.b.speed_factor' sets the same value; leave one "
            "out");
}

TEST(Set, IsRefusedForSettingsThatTheFileVaries) {
  EXPECT_EQ(refusal_of_assignments("factors: { b.handicap: [1.0, 0.5] }\n",
                                   {{"--set b.handicap=1", "teams.b.handicap", "1"}}),
            "--set b.handicap=1: the file varies this setting; change it there");
  EXPECT_EQ(refusal_of_assignments("factors: { b.handicap: [1.0, 0.5] }\n",
                                   {{"--set seed=1", "seed", "1"}}),
            "--set seed=1: set automatically for each game; leave it out");
}

TEST(Set, ReachesTheBaseAndTeamsByName) {
  const std::string text =
      "schema: 1\nkind: roundrobin\npairs: 1\nseed: 1\n"
      "teams: { one: { strategy: basic }, two: { strategy: basic, robots: 5 } }\n";
  const game::Assignments sets =
      game::assignments_in({"teams.one.players.2.handicap=0.5", "teams.two.params.shot_mps=5",
                            "match.half_s=7", "match.rules=2026-a"});
  const auto robin = *read_scenario_text(text, "x.yaml", sets).as<RoundRobin>();
  EXPECT_EQ(robin.base.match.half_s, 7);
  EXPECT_EQ(robin.teams.at("one").robots, 11);
  EXPECT_EQ(robin.teams.at("one").players.at(2).speed_factor, 0.5);
  EXPECT_EQ(robin.teams.at("two").robots, 5);
  EXPECT_EQ(robin.teams.at("two").params.at("shot_mps"), 5);
  try {
    read_scenario_text(text, "x.yaml", game::assignments_in({"teams.oen.robots=5"}));
    FAIL() << "accepted";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'teams.one'"), std::string::npos)
        << error.what();
  }
}

TEST(UnknownKey, IsLookedUpInOtherBranches) {
  EXPECT_EQ(refusal_of_assignments("factors: { half_s: [60, 120] }\n"),
            "x.yaml:5:21: half_s: unknown key 'half_s'; did you mean 'match.half_s'?");
  for (const char* base : {"base: { half_s: 60 }\n", "base: { teams: { a: { half_s: 60 } } }\n"}) {
    const std::string refusal =
        refusal_of_assignments(std::string(base) + "factors: { b.robots: [6, 5] }\n");
    EXPECT_TRUE(refusal.ends_with("; elsewhere: match.half_s")) << refusal;
  }
}

TEST(Set, DoesNotMindSpacesAroundItsEqualsSign) {
  const game::Assignments sets =
      game::assignments_in({"match.half_s = 60", " b.command= python3 my_team.py "});
  EXPECT_EQ(sets[0].path, "match.half_s");
  EXPECT_EQ(sets[0].value, "60");
  EXPECT_EQ(sets[1].path, "b.command");
  EXPECT_EQ(sets[1].value, "python3 my_team.py");
  EXPECT_THROW(game::assignments_in({" = 60"}), io::InputError);
}

TEST(Set, RefusesAHandicapTogetherWithOneOfItsFactorsInAnyOrder) {
  for (const auto& sets : {std::vector<std::string>{"b.handicap=0.5", "b.speed_factor=0.8"},
                           std::vector<std::string>{"b.speed_factor=0.8", "b.handicap=0.5"}}) {
    EXPECT_THROW(game::assignments_in(sets), io::InputError);
  }
}

}  // namespace
}  // namespace autoref::experiments
