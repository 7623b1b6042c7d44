// The parts of a comparison's difference: they add up, and find what differs.
#include "experiments/analysis/difference_parts.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

#include "experiments/schedule/schedule.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

constexpr auto kCorner = static_cast<std::size_t>(game::ChainStart::kCornerKick);
constexpr auto kDuel = static_cast<std::size_t>(game::ChainStart::kDuel);

// Changes what a team does in a game; `random` are numbers for this team and game.
using Change = std::function<void(game::PlayCounts& team, RandomStream& random)>;

double chance_from(RandomStream& random) { return 0.5 * square(random.normal()); }

// Chances, shots and own goals at random.
game::PlayCounts random_counts(RandomStream& random) {
  game::PlayCounts team;
  for (game::ChainCounts& chains : team.by_start) {
    chains.xg = chance_from(random);
    team.with_pass.xg += 0.4 * chains.xg;
    team.xg += chains.xg;
  }
  team.xgot = team.xg * (1 + 0.2 * random.normal());
  team.own_goals = random.normal() > 2 ? 1 : 0;
  return team;
}

// Rows of games between teams that are equal except for what `change` does to the new team.
class Games {
 public:
  Games(std::vector<PairedOpponent> opponents, int pairs, std::uint64_t seed, Change change = {})
      : opponents_(std::move(opponents)), random_(seed), change_(std::move(change)) {
    for (int pair = 1; pair <= pairs; ++pair) {
      pairs_.push_back(pair);
      for (const PairedOpponent& opponent : opponents_) {
        add(opponent.of_new, pair, true);
        if (opponent.of_old) add(*opponent.of_old, pair, false);
      }
    }
  }

  DifferenceParts parts() const { return difference_parts(opponents_, pairs_, rows_); }

  // The difference in goals computed directly.
  double goal_difference() const {
    double sum = 0;
    for (const PairedOpponent& opponent : opponents_) {
      sum += difference_of(opponent.of_new);
      if (opponent.of_old) sum -= difference_of(*opponent.of_old);
    }
    return sum / static_cast<double>(opponents_.size());
  }

 private:
  void add(const std::string& matchup, int pair, bool is_new) {
    for (const int leg : {1, 2}) {
      game::GameRecord record;
      for (game::PlayCounts& team : record.counts) team = random_counts(random_);
      if (is_new && change_) change_(record.counts[0], random_);
      record.goals_a = static_cast<int>(record.counts[0].xgot + square(random_.normal()));
      record.goals_b = static_cast<int>(record.counts[1].xgot + square(random_.normal()));
      rows_[game_id(matchup, pair, leg)].record = record;
    }
  }
  double difference_of(const std::string& matchup) const {
    double sum = 0;
    for (const int pair : pairs_) {
      for (const int leg : {1, 2}) {
        const game::GameRecord& record = rows_.at(game_id(matchup, pair, leg)).record;
        sum += record.goals_a - record.goals_b;
      }
    }
    return sum / 2 / static_cast<double>(pairs_.size());
  }

  std::vector<PairedOpponent> opponents_;
  std::vector<int> pairs_;
  RandomStream random_;
  Change change_;
  RowsById rows_;
};

const std::vector<PairedOpponent> kEachOther = {{"new~old", std::nullopt}};
const std::vector<PairedOpponent> kThree = {
    {"new~old", std::nullopt}, {"new~x", "old~x"}, {"new~y", "old~y"}};

double sum_of(const std::vector<DifferencePart>& parts, double DifferencePart::*member) {
  double sum = 0;
  for (const DifferencePart& part : parts) sum += part.*member;
  return sum;
}

TEST(DifferenceParts, AddUpInTwoHundredExperiments) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Games games(seed % 2 == 0 ? kEachOther : kThree, 12, seed);
    const DifferenceParts parts = games.parts();
    for (const auto member : {&DifferencePart::mean, &DifferencePart::each_other,
                              &DifferencePart::attack, &DifferencePart::defence}) {
      EXPECT_NEAR(sum_of(parts.by_start, member), parts.chances.*member, 1e-9);
      EXPECT_NEAR(sum_of(parts.by_passes, member), parts.chances.*member, 1e-9);
      EXPECT_NEAR(parts.chances.*member + sum_of(parts.others, member), parts.goals.*member, 1e-9);
    }
    EXPECT_NEAR(parts.goals.mean, games.goal_difference(), 1e-9);
    for (const DifferencePart& part : parts.by_start)
      EXPECT_NEAR((part.interval->low + part.interval->high) / 2, part.mean, 1e-9);
  }
}

std::string most_certain_after(const std::vector<PairedOpponent>& opponents, const Change& change) {
  const DifferenceParts parts = Games(opponents, 50, 7, change).parts();
  const DifferencePart* part = parts.most_certain();
  return part == nullptr ? "none" : part->name;
}

TEST(DifferenceParts, NameWhatDiffersMostSurely) {
  const auto without_corners = [](game::PlayCounts& team, RandomStream& /*random*/) {
    game::ChainCounts& corners = team.by_start[kCorner];
    team.xg -= corners.xg;
    team.xgot -= corners.xg;
    team.with_pass.xg -= 0.4 * corners.xg;
    corners.xg = 0;
  };
  const auto without_passes = [](game::PlayCounts& team, RandomStream& /*random*/) {
    team.with_pass.xg = 0;
  };
  const auto with_better_aim = [](game::PlayCounts& team, RandomStream& /*random*/) {
    team.xgot += 1;
  };
  for (const auto& opponents : {kEachOther, kThree}) {
    EXPECT_EQ(most_certain_after(opponents, without_corners), "chances from corner kicks");
    EXPECT_EQ(most_certain_after(opponents, without_passes), "chances with a pass");
    EXPECT_EQ(most_certain_after(opponents, with_better_aim), "finishing");
  }
}

TEST(DifferenceParts, NameNothingBetweenEqualTeams) {
  int named = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    named += Games(kEachOther, 30, 1000 + seed).parts().most_certain() == nullptr ? 0 : 1;
  EXPECT_LE(named, 5);
}

// One pair: new scores twice, with xG 0.5 from a duel and xGOT 1.2; old scores an own goal for new.
TEST(DifferenceParts, AreThoseOfTheRows) {
  game::GameRecord record;
  record.goals_a = 3;
  record.goals_b = 1;
  record.counts[0].by_start[kDuel].xg = 0.5;
  record.counts[0].xgot = 1.2;
  record.counts[1].own_goals = 1;
  record.counts[1].by_start[kCorner].xg = 0.75;
  record.counts[1].with_pass.xg = 0.75;
  record.counts[1].xgot = 0.25;
  RowsById rows;
  for (const int leg : {1, 2}) rows[game_id("new~old", 1, leg)].record = record;
  const DifferenceParts parts = difference_parts(kEachOther, {1}, rows);
  EXPECT_DOUBLE_EQ(parts.by_start[kDuel].mean, 0.5);
  EXPECT_DOUBLE_EQ(parts.by_start[kCorner].mean, -0.75);
  EXPECT_DOUBLE_EQ(parts.by_passes[0].mean, -0.75);
  EXPECT_DOUBLE_EQ(parts.by_passes[1].mean, 0.5);
  EXPECT_DOUBLE_EQ(parts.others[0].of_new, 0.7);
  EXPECT_DOUBLE_EQ(parts.others[0].of_old, -0.5);
  EXPECT_DOUBLE_EQ(parts.others[1].of_new, 0.25 - 1);
  EXPECT_DOUBLE_EQ(parts.others[1].of_old, 1.2 - 2);
  EXPECT_DOUBLE_EQ(parts.others[2].mean, 1);
  EXPECT_DOUBLE_EQ(parts.goals.of_new, 3);
  EXPECT_DOUBLE_EQ(parts.goals.of_old, 1);
  EXPECT_DOUBLE_EQ(parts.goals.mean, 2);
  EXPECT_FALSE(parts.goals.interval);
}

// The keeper of the new team saves more against a common opponent, so this belongs to defence.
TEST(DifferenceParts, CountTheKeeperAsDefence) {
  RowsById rows;
  for (const int leg : {1, 2}) {
    game::GameRecord record;
    record.counts[1].xgot = 1;
    rows[game_id("new~x", 1, leg)].record = record;
    record.goals_b = 1;
    rows[game_id("old~x", 1, leg)].record = record;
  }
  const DifferenceParts parts = difference_parts({{"new~x", "old~x"}}, {1}, rows);
  EXPECT_DOUBLE_EQ(parts.others[1].defence, 1);
  EXPECT_DOUBLE_EQ(parts.others[1].attack, 0);
  EXPECT_DOUBLE_EQ(parts.goals.defence, 1);
}

}  // namespace
}  // namespace autoref::experiments
