// Pairings of Swiss tournaments.
#include "experiments/kinds/swiss/swiss_rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

using Meetings = std::vector<std::pair<DrawnTeam, DrawnTeam>>;

std::vector<DrawnTeam> in_order(std::size_t teams) {
  std::vector<DrawnTeam> order(teams);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

Encounters after(std::size_t teams, const Meetings& meetings) {
  Encounters past(teams);
  for (const auto& [one, other] : meetings) past.add_meeting(one, other);
  return past;
}

// What happens if rounds end at random: who met again, and how often teams had a bye.
struct PlayedOut {
  int rematches = 0;
  std::vector<int> byes;
  bool has_everybody_once = true;  // in each round
};

PlayedOut play_out(std::size_t teams, int rounds, std::uint64_t seed) {
  PlayedOut result{0, std::vector<int>(teams)};
  Encounters past(teams);
  RandomStream random(seed);
  std::vector<DrawnTeam> ranking = in_order(teams);
  for (int round = 0; round < rounds; ++round) {
    const RoundPairing pairing = round == 0 ? first_pairing(teams) : next_pairing(ranking, past);
    std::vector<DrawnTeam> seen;
    for (const auto& [one, other] : pairing.meetings) {
      result.rematches += past.have_met(one, other) ? 1 : 0;
      past.add_meeting(one, other);
      seen.insert(seen.end(), {one, other});
    }
    if (pairing.bye) {
      ++result.byes[*pairing.bye];
      past.add_bye(*pairing.bye);
      seen.push_back(*pairing.bye);
    }
    std::sort(seen.begin(), seen.end());
    result.has_everybody_once = result.has_everybody_once && seen == in_order(teams);
    for (std::size_t left = teams; left > 1; --left)
      std::swap(ranking[left - 1], ranking[random() % left]);
  }
  return result;
}

TEST(FirstPairing, HasTheTopHalfAgainstTheBottomHalf) {
  const RoundPairing pairing = first_pairing(6);
  EXPECT_EQ(pairing.meetings, (Meetings{{0, 3}, {1, 4}, {2, 5}}));
  EXPECT_FALSE(pairing.bye);
}

TEST(FirstPairing, GivesTheLastOfAnOddNumberABye) {
  const RoundPairing pairing = first_pairing(5);
  EXPECT_EQ(pairing.meetings, (Meetings{{0, 2}, {1, 3}}));
  EXPECT_EQ(pairing.bye, 4U);
}

TEST(NextPairing, HasNeighboursOfTheRanking) {
  const Encounters past = after(6, {{0, 3}, {1, 4}, {2, 5}});
  EXPECT_EQ(next_pairing({5, 0, 1, 2, 3, 4}, past).meetings, (Meetings{{5, 0}, {1, 2}, {3, 4}}));
}

TEST(NextPairing, SkipsTeamsThatHaveMet) {
  EXPECT_EQ(next_pairing({0, 1, 2, 3}, after(4, {{0, 1}, {2, 3}})).meetings,
            (Meetings{{0, 2}, {1, 3}}));
}

// 0 and 1 have not met, but then 2 and 3 would meet again.
TEST(NextPairing, DoesNotLeaveTeamsOverThatHaveMet) {
  EXPECT_EQ(next_pairing({0, 1, 2, 3}, after(4, {{2, 3}})).meetings, (Meetings{{0, 2}, {1, 3}}));
}

// Those left to meet are two groups of three, so that one rematch joins the groups.
TEST(NextPairing, HasAsFewRematchesAsPossible) {
  const Encounters past =
      after(6, {{0, 3}, {1, 4}, {2, 5}, {0, 4}, {1, 5}, {2, 3}, {0, 5}, {1, 3}, {2, 4}});
  EXPECT_EQ(next_pairing(in_order(6), past).meetings, (Meetings{{0, 1}, {2, 3}, {4, 5}}));
}

TEST(NextPairing, GivesTheLowestTeamWithoutOneABye) {
  Encounters past(5);
  past.add_bye(4);
  const RoundPairing pairing = next_pairing(in_order(5), past);
  EXPECT_EQ(pairing.bye, 3U);
  EXPECT_EQ(pairing.meetings, (Meetings{{0, 1}, {2, 4}}));
}

// If 2 had the bye, 0 and 1 would meet again.
TEST(NextPairing, GivesAHigherTeamTheByeIfThatAvoidsARematch) {
  const RoundPairing pairing = next_pairing({0, 1, 2}, after(3, {{0, 1}}));
  EXPECT_EQ(pairing.bye, 1U);
  EXPECT_EQ(pairing.meetings, (Meetings{{0, 2}}));
}

TEST(NextPairing, RefusesToGiveASecondBye) {
  Encounters past(3);
  for (const DrawnTeam team : {0U, 1U, 2U}) past.add_bye(team);
  EXPECT_THROW(next_pairing(in_order(3), past), std::logic_error);
}

class PlayedOutRounds : public testing::TestWithParam<std::size_t> {};

TEST_P(PlayedOutRounds, HaveNoRematchInHalfAsManyRoundsAsTeams) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PlayedOut result = play_out(GetParam(), static_cast<int>(GetParam() / 2), seed);
    EXPECT_EQ(result.rematches, 0) << seed;
    EXPECT_TRUE(result.has_everybody_once) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, PlayedOutRounds, testing::Values(2, 3, 4, 5, 6, 7, 10, 13, 32),
                         [](const auto& test) { return std::to_string(test.param) + "Teams"; });

TEST(NextPairing, GivesEveryTeamOneByeInAsManyRoundsAsTeams) {
  for (const std::size_t teams : {3U, 5U, 7U, 13U})
    EXPECT_EQ(play_out(teams, static_cast<int>(teams), 1).byes, std::vector<int>(teams, 1));
}

TEST(NextPairing, BringsSixtyFourTeamsThroughSixtyThreeRounds) {
  EXPECT_TRUE(play_out(64, 63, 1).has_everybody_once);
}

}  // namespace
}  // namespace autoref::experiments
