#include "experiments/analysis/saturation.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/csv.hpp"
#include "strategies/registry.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::experiments {
namespace {

// Games against an opponent: the numbers of those won, drawn and lost, and of those that the side
// which won more ended by its lead in goals.
Group games_with(int won, int drawn, int lost, int ended_by_lead) {
  Group group;
  group.wins_a = won;
  group.draws = drawn;
  group.wins_b = lost;
  (won > lost ? group.lead_ends_a : group.lead_ends_b) = ended_by_lead;
  const int games = won + drawn + lost;
  group.differences.resize(static_cast<std::size_t>(games));
  return group;
}

game::TeamSettings team(const std::string& strategy) {
  game::TeamSettings settings;
  settings.strategy = strategy;
  return settings;
}

std::string text_for(const Group& one, const Group& other, const std::string& strategy = "basic") {
  return saturation_text("it", team(strategy), {&one, &other}, "or otherwise");
}

TEST(Saturation, IsNoticedIfHalfOfTheGamesEndByTheLead) {
  EXPECT_EQ(
      text_for(games_with(0, 1, 19, 16), games_with(0, 0, 20, 15)),
      "it is too strong for a comparison of these teams: 31 of 40 games ended early because of "
      "the lead in goals. Play against a weaker team, such as chaser, or otherwise.");
  EXPECT_EQ(text_for(games_with(3, 1, 16, 10), games_with(2, 1, 17, 9)), "");
}

TEST(Saturation, IsNoticedIfOneSideWinsAllGames) {
  EXPECT_NE(text_for(games_with(20, 0, 0, 0), games_with(20, 0, 0, 0))
                .find("it is too weak for a comparison of these teams: it lost all 40 games. Play "
                      "against a stronger team, such as zone,"),
            std::string::npos);
  EXPECT_NE(text_for(games_with(0, 0, 20, 0), games_with(0, 0, 20, 0)).find("it won all 40 games"),
            std::string::npos);
  EXPECT_EQ(text_for(games_with(20, 0, 0, 0), games_with(19, 1, 0, 0)), "");
}

// An opponent that only one of two teams beats shows best which of them is better.
TEST(Saturation, NeedsTheSameSideToWinAgainstEveryTeam) {
  EXPECT_EQ(text_for(games_with(20, 0, 0, 20), games_with(0, 0, 20, 20)), "");
  EXPECT_EQ(text_for(games_with(20, 0, 0, 20), games_with(8, 4, 8, 0)), "");
}

TEST(Saturation, IsNotClaimedForAFewGames) {
  EXPECT_EQ(text_for(games_with(4, 0, 0, 4), games_with(5, 0, 0, 5)), "");
}

TEST(Saturation, NamesATeamOnlyIfItKnowsOne) {
  const Group won = games_with(20, 0, 0, 0);
  EXPECT_NE(text_for(won, won, "cobalt").find("a stronger team, or otherwise"), std::string::npos);
  EXPECT_NE(text_for(won, won, "rowdy").find("a stronger team, or otherwise"), std::string::npos);
  game::TeamSettings program = team("basic");
  program.program.command = {"python3", "team.py"};
  EXPECT_NE(
      saturation_text("it", program, {&won}, "or otherwise").find("a stronger team, or otherwise"),
      std::string::npos);
}

TEST(TeamsByStrength, AreRankedAsInTheCommittedRoundRobin) {
  const std::string csv = content_of(in_checkout("results/reference/roundrobin/standings.csv"));
  const std::vector<std::string_view> lines = io::complete_lines(csv);
  const std::vector<std::string_view>& teams = strategies::teams_by_strength();
  ASSERT_EQ(lines.size(), teams.size() + 1);
  for (std::size_t i = 0; i < teams.size(); ++i)
    EXPECT_EQ(io::csv_cells(lines[i + 1]).value().at(1), teams[i]);
}

}  // namespace
}  // namespace autoref::experiments
