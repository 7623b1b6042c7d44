// What must hold for every kind of experiment.
#include "experiments/kinds/all_kinds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "tests/checkout.hpp"

namespace autoref::experiments {
namespace {

class EveryKind : public testing::TestWithParam<const Kind*> {
 protected:
  const Kind& kind() const { return *GetParam(); }

  // The committed scenarios of this kind.
  std::vector<Scenario> scenarios() const {
    std::vector<Scenario> all;
    for (const auto& file : std::filesystem::directory_iterator(in_checkout("scenarios"))) {
      if (file.path().extension() != ".yaml") continue;
      Scenario scenario = read_scenario(file.path());
      if (kind_of(scenario) == kind().name) all.push_back(std::move(scenario));
    }
    return all;
  }
};

TEST_P(EveryKind, IsFoundByItsNameAndMadeWithIt) {
  EXPECT_EQ(find_kind(kind().name), GetParam());
  EXPECT_EQ(&kind().make()->kind(), GetParam());
  EXPECT_NE(kind().name, kGameKind);
}

TEST_P(EveryKind, ExplainsEachKeyOnce) {
  const std::unique_ptr<Experiment> experiment = kind().make();
  std::set<std::string> names;
  for (const Key& key : experiment->keys()) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name;
    EXPECT_FALSE(key.about.empty()) << key.name;
  }
}

TEST_P(EveryKind, HasOneBaseAndASeed) {
  const std::unique_ptr<Experiment> experiment = kind().make();
  const std::vector<Key> keys = experiment->keys();
  EXPECT_EQ(
      std::count_if(keys.begin(), keys.end(), [](const Key& key) { return key.base != nullptr; }),
      1);
  set_master_seed(*experiment, 77);
  EXPECT_EQ(master_seed_of(*experiment), 77U);
  EXPECT_EQ(seed_text(*experiment), "77");
}

TEST_P(EveryKind, SaysWhyItHasNoPairs) {
  const std::unique_ptr<Experiment> experiment = kind().make();
  const std::vector<Key> keys = experiment->keys();
  const bool has_pairs =
      std::any_of(keys.begin(), keys.end(), [](const Key& key) { return key.pairs != nullptr; });
  EXPECT_NE(has_pairs, !experiment->why_no_pairs().empty());
}

// A copy's keys lead into the copy.
TEST_P(EveryKind, IsCopiedWithAllItsSettings) {
  const std::vector<Scenario> all = scenarios();
  ASSERT_FALSE(all.empty()) << "no scenario is of kind " << kind().name;
  for (const Scenario& scenario : all) {
    Scenario copy = scenario;
    EXPECT_EQ(effective_text(copy), effective_text(scenario));
    set_master_seed(copy.experiment(), 77);
    EXPECT_NE(seed_text(scenario.experiment()), "77");
  }
}

TEST_P(EveryKind, SchedulesGamesWithDifferentIds) {
  for (const Scenario& scenario : scenarios()) {
    std::set<std::string> ids;
    const std::vector<ScheduledGame> games = scenario.experiment().games();
    EXPECT_FALSE(games.empty());
    for (const ScheduledGame& game : games) EXPECT_TRUE(ids.insert(game.id).second) << game.id;
    const Schedule schedule = scenario.experiment().schedule({});
    for (const ScheduledGame& game : schedule.games)
      EXPECT_EQ(game.values.size(), scenario.experiment().value_columns().size()) << game.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, EveryKind,
                         testing::ValuesIn(kinds_of_experiments().begin(),
                                           kinds_of_experiments().end()),
                         [](const auto& test) { return std::string(test.param->name); });

TEST(Kinds, AreListedByTheirVerbs) {
  EXPECT_EQ(kinds_played_by("judge"), "judge");
  EXPECT_TRUE(kinds_played_by("run").ends_with(" or tune"));
  EXPECT_EQ(kinds_played_by("nothing"), "");
}

TEST(Kinds, OfOtherNamesAreUnknown) { EXPECT_EQ(find_kind("zzz"), nullptr); }

}  // namespace
}  // namespace autoref::experiments
