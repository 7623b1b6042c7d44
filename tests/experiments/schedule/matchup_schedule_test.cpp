#include "experiments/schedule/matchup_schedule.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>

#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "game/settings/fields.hpp"

namespace autoref::experiments {
namespace {

// A round robin between these teams, each with a different number of robots.
RoundRobin robin_of(const std::vector<std::string>& names, int pairs) {
  RoundRobin robin;
  for (const std::string& name : names) {
    robin.teams[name].robots = static_cast<int>(robin.teams.size()) + 1;
  }
  robin.pairs = pairs;
  robin.seed = 7;
  return robin;
}

std::vector<std::string> ids_of(const RoundRobin& robin) {
  std::vector<std::string> ids;
  for (const ScheduledGame& game : robin.games()) ids.push_back(game.id);
  return ids;
}

TEST(Matchups, PairAllTeamsInAlphabeticalOrder) {
  const std::vector<Matchup> expected = {{"bold", "calm"}, {"bold", "zone"}, {"calm", "zone"}};
  EXPECT_EQ(matchups_among(robin_of({"zone", "bold", "calm"}, 1).teams), expected);
}

TEST(RoundRobinSchedule, SpreadsPairsOverAllMatchupsWithTheirLegsBackToBack) {
  const std::vector<std::string> expected = {
      "bold~calm-p0001-1", "bold~calm-p0001-2", "bold~zone-p0001-1", "bold~zone-p0001-2",
      "calm~zone-p0001-1", "calm~zone-p0001-2", "bold~calm-p0002-1", "bold~calm-p0002-2",
      "bold~zone-p0002-1", "bold~zone-p0002-2", "calm~zone-p0002-1", "calm~zone-p0002-2"};
  EXPECT_EQ(ids_of(robin_of({"zone", "bold", "calm"}, 2)), expected);
}

TEST(RoundRobinSchedule, GivesEachTeamItsOwnSettingsAndName) {
  RoundRobin robin = robin_of({"zone", "bold"}, 1);
  robin.base.match.half_s = 60;
  const ScheduledGame game = robin.games().back();
  EXPECT_EQ(game.team_a, "bold");
  EXPECT_EQ(game.settings.combined().a.robots, robin.teams["bold"].robots);
  EXPECT_EQ(game.settings.combined().b.robots, robin.teams["zone"].robots);
  EXPECT_EQ(game.settings.combined().match.half_s, 60);
}

TEST(RoundRobinSchedule, DerivesSeedAndSidesFromMasterSeedPairAndLegOnly) {
  std::map<std::pair<int, int>, std::set<std::uint64_t>> seeds;
  for (const ScheduledGame& game : robin_of({"zone", "bold", "calm"}, 4).games()) {
    seeds[{game.pair, game.leg}].insert(game.settings.combined().seed);
    EXPECT_EQ(game.settings.combined().match.a_plays, game.leg == 1 ? Side::kWest : Side::kEast);
  }
  EXPECT_EQ(seeds.size(), 8U);
  for (const auto& [leg, its] : seeds) {
    EXPECT_EQ(its, std::set<std::uint64_t>{seed_of(7, leg.first, leg.second)});
  }
}

TEST(RoundRobinSchedule, KeepsAllGamesWhenTeamsOrPairsAreAdded) {
  std::map<std::string, std::uint64_t> hashes;
  RoundRobin many = robin_of({"zone", "bold"}, 5);
  many.teams["calm"] = {};
  for (const ScheduledGame& game : many.games()) {
    hashes[game.id] = game::configuration_hash(game.settings.combined());
  }
  for (const ScheduledGame& game : robin_of({"zone", "bold"}, 2).games()) {
    EXPECT_EQ(hashes.at(game.id), game::configuration_hash(game.settings.combined())) << game.id;
  }
}

TEST(RoundRobinSchedule, NamesTheInvalidSetting) {
  RoundRobin robin = robin_of({"zone", "bold"}, 1);
  robin.teams["bold"].params["shots"] = 1;
  try {
    robin.games();
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("teams.bold.params.shots: "));
  }
}

}  // namespace
}  // namespace autoref::experiments
