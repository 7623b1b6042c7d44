#include <gtest/gtest.h>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/swiss/swiss.hpp"
#include "tests/experiments/reading/mistake.hpp"

namespace autoref::experiments {
namespace {

const std::string kSwissTop = "schema: 1\nkind: swiss\nseed: 7\n";
const std::string kSwissTeams = "teams: { zone: {}, bold: {}, calm: {}, dour: {} }\n";
const std::string kSwissFile = kSwissTop + kSwissTeams + "rounds: 2\npairs: 3\n";

Swiss swiss_read_from(const std::string& text) {
  return *read_scenario_text(text, "x.yaml").as<Swiss>();
}

TEST(ReadSwiss, ReadsTeamsRoundsPairsAndSeed) {
  const Swiss swiss = swiss_read_from(kSwissFile);
  EXPECT_EQ(swiss.teams.size(), 4U);
  EXPECT_EQ(swiss.rounds, 2);
  EXPECT_EQ(swiss.pairs, 3);
  EXPECT_EQ(swiss.seed, 7U);
}

TEST(EffectiveConfiguration, OfASwissTournamentReadsBackEqual) {
  const std::string text = effective_text({"A test.", swiss_read_from(kSwissFile)});
  EXPECT_EQ(effective_text(read_scenario_text(text, "x.yaml")), text);
}

TEST(MostRounds, LetEveryTeamMeetEveryOther) {
  EXPECT_EQ(most_rounds(2), 1);
  EXPECT_EQ(most_rounds(5), 5);
  EXPECT_EQ(most_rounds(6), 5);
}

TEST(ChangesBetween, OfSwissTournamentsHaveNeitherRoundsNorPairs) {
  Swiss other = swiss_read_from(kSwissFile);
  other.rounds = 3;
  other.pairs = 1;
  EXPECT_EQ(changes_between(swiss_read_from(kSwissFile), other), "");
}

class WrongSwiss : public testing::TestWithParam<Mistake> {};

TEST_P(WrongSwiss, IsRefusedWithItsLocationAndARemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongSwiss,
    testing::Values(Mistake{"OneTeam",
                            kSwissTop + "teams: { zone: {} }\nrounds: 1\npairs: 1\n",
                            "x.yaml:4:1: teams: ",
                            {"expected 2 to 64 teams", "found 1"}},
                    Mistake{"NoRounds",
                            kSwissTop + kSwissTeams + "pairs: 1\n",
                            "x.yaml:1:1: ",
                            {"'rounds' is missing"}},
                    Mistake{"NoPairs",
                            kSwissTop + kSwissTeams + "rounds: 1\n",
                            "x.yaml:1:1: ",
                            {"'pairs' is missing"}},
                    Mistake{"ZeroRounds",
                            kSwissTop + kSwissTeams + "rounds: 0\npairs: 1\n",
                            "x.yaml:5:9: rounds: ",
                            {"whole number from 1 to 63", "found '0'"}},
                    Mistake{"MoreRoundsThanOpponents",
                            kSwissTop + kSwissTeams + "rounds: 4\npairs: 1\n",
                            "x.yaml:5:1: rounds",
                            {"is 4", "4 teams can play from 1 to 3"}},
                    Mistake{"MorePairNumbersThanAnIdHas",
                            kSwissTop + kSwissTeams + "rounds: 3\npairs: 3334\n",
                            "x.yaml:6:1: pairs",
                            {"is 3334", "in 3 rounds, at most 3333"}},
                    Mistake{"Order",
                            kSwissFile + "order: [zone, bold, calm, dour]\n",
                            "x.yaml:7:1: ",
                            {"unknown key 'order'"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
