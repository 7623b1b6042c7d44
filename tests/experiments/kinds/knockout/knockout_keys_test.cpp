#include <gtest/gtest.h>

#include "experiments/kinds/knockout/knockout.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "tests/experiments/reading/mistake.hpp"

namespace autoref::experiments {
namespace {

const std::string kKnockoutTop = "schema: 1\nkind: knockout\nseed: 7\n";
const std::string kKnockoutTeams = "teams: { zone: {}, bold: {}, calm: {} }\n";

Knockout read(const std::string& text) {
  return *read_scenario_text(kKnockoutTop + kKnockoutTeams + text, "x.yaml").as<Knockout>();
}

TEST(ReadKnockout, SeedsTeamsByNameUnlessAnOrderIsGiven) {
  EXPECT_EQ(read("").order, (std::vector<std::string>{"bold", "calm", "zone"}));
  EXPECT_EQ(read("order: [zone, bold, calm]\n").order,
            (std::vector<std::string>{"zone", "bold", "calm"}));
}

TEST(ReadKnockout, EnablesExtraTimeIfTheRulesHaveItUnlessTheBaseDisablesIt) {
  EXPECT_FALSE(read("").base.match.knockout);
  EXPECT_TRUE(read("base: { match: { rules: 2026-b } }\n").base.match.knockout);
  EXPECT_FALSE(read("base: { match: { rules: 2026-b, knockout: false } }\n").base.match.knockout);
}

TEST(EffectiveConfiguration, OfAKnockoutReadsBackEqual) {
  Knockout knockout = read("order: [zone, bold, calm]\n");
  knockout.order.push_back("last");
  knockout.teams["last"].robots = 5;
  knockout.third_place = true;
  const std::string text = effective_text({"A test.", knockout});
  EXPECT_EQ(effective_text(read_scenario_text(text, "x.yaml")), text);
}

class WrongKnockout : public testing::TestWithParam<Mistake> {};

TEST_P(WrongKnockout, IsRefusedWithItsLocationAndARemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongKnockout,
    testing::Values(Mistake{"OneTeam",
                            kKnockoutTop + "teams: { zone: {} }\n",
                            "x.yaml:4:1: teams: ",
                            {"expected 2 to 64 teams", "found 1"}},
                    Mistake{"OrderIsAWord",
                            kKnockoutTop + kKnockoutTeams + "order: zone\n",
                            "x.yaml:5:8: order: ",
                            {"every team once", "bold, calm, zone"}},
                    Mistake{"UnknownTeamInTheOrder",
                            kKnockoutTop + kKnockoutTeams + "order: [zone, bold, clam]\n",
                            "x.yaml:5:21: order: ",
                            {"bold, calm, zone", "'clam', which is not a team"}},
                    Mistake{"TeamTwiceInTheOrder",
                            kKnockoutTop + kKnockoutTeams + "order: [zone, bold, zone]\n",
                            "x.yaml:5:21: order: ",
                            {"'zone' twice"}},
                    Mistake{"TeamMissingInTheOrder",
                            kKnockoutTop + kKnockoutTeams + "order: [zone, bold]\n",
                            "x.yaml:5:8: order: ",
                            {"'calm' is missing"}},
                    Mistake{"ThirdPlaceOfThree",
                            kKnockoutTop + kKnockoutTeams + "third_place: true\n",
                            "x.yaml:5:14: third_place: ",
                            {"at least 4 teams", "leave this key out"}},
                    Mistake{"ThirdPlaceIsAWord",
                            kKnockoutTop + kKnockoutTeams + "third_place: maybe\n",
                            "x.yaml:5:14: third_place: ",
                            {"true, false"}},
                    Mistake{"Pairs",
                            kKnockoutTop + kKnockoutTeams + "pairs: 5\n",
                            "x.yaml:5:1: ",
                            {"unknown key 'pairs'"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
