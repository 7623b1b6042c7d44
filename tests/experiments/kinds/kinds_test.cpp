#include "experiments/kinds/experiment.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/gauntlet/gauntlet.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

TEST(ChangesBetween, ListsEachSettingThatDiffers) {
  Sweep here;
  Sweep there;
  here.base.match.half_s = 60;
  here.seed = 5;
  EXPECT_EQ(changes_between(here, there),
            "match.half_s is 60.0 here and 600.0 there; seed is 5 here and 1 there");
  EXPECT_EQ(changes_between(there, there), "");
}

TEST(ChangesBetween, ListsPlayersThatOnlyOneOfThemHas) {
  Sweep here;
  Sweep there;
  here.base.b.players[3].speed_factor = 0.5;
  EXPECT_NE(changes_between(here, there)
                .find("teams.b.players.3.speed_factor is 0.5 here and not given there"),
            std::string::npos);
  EXPECT_NE(changes_between(there, here)
                .find("teams.b.players.3.speed_factor is not given here and 0.5 there"),
            std::string::npos);
}

TEST(ChangesBetween, LeavesOutTeamsThatOnlyOneOfThemHas) {
  EXPECT_EQ(
      changes_between(small_roundrobin({6, 5}).experiment(), small_roundrobin({6}).experiment()),
      "");
  EXPECT_EQ(changes_between(small_roundrobin({6, 5}).experiment(),
                            small_roundrobin({6, 4, 3}).experiment()),
            "teams.team1.robots is 5 here and 4 there");
}

TEST(ChangesBetween, AreEmptyForDifferentKinds) {
  EXPECT_EQ(changes_between(small_roundrobin({6, 5}).experiment(), small_sweep().experiment()), "");
}

// The heads of the columns that a narrow screen leaves out, in that order, of each table.
std::vector<io::Cells> spared_in(const Scenario& scenario) {
  std::vector<io::Cells> spared;
  for (const io::ProgressTable& table : scenario.experiment().results({}).shown) {
    spared.emplace_back();
    for (const std::size_t column : table.dispensable)
      spared.back().push_back(table.rows.front().at(column));
  }
  return spared;
}

const io::Cells kSparedOfMatchups = {"goals b", "goals a", "void", "games", "a minus b [95 %]"};

TEST(ShownTables, OfASweepSpareGoalsAndVoidGames) {
  EXPECT_EQ(spared_in(small_sweep()), (std::vector<io::Cells>{{"goals b", "goals a", "void"}}));
}

TEST(ShownTables, OfARoundRobinSpareRatingsAndGames) {
  EXPECT_EQ(spared_in(small_roundrobin({6, 5})),
            (std::vector<io::Cells>{{"Bradley-Terry [95 %]", "rating in goals [95 %]", "games"},
                                    kSparedOfMatchups}));
}

TEST(ShownTables, OfAGauntletSpareTheDifferenceAndGames) {
  Gauntlet gauntlet;
  gauntlet.challengers["bold"].robots = 6;
  gauntlet.teams["zone"].robots = 5;
  EXPECT_EQ(spared_in({"", gauntlet}),
            (std::vector<io::Cells>{{"goal difference [95 %]", "games"}, kSparedOfMatchups}));
}

TEST(ShownTables, OfAnSprtMatchSpareWhatOtherColumnsSay) {
  EXPECT_EQ(spared_in(small_sprt_match()), std::vector<io::Cells>{kSparedOfMatchups});
}

}  // namespace
}  // namespace autoref::experiments
