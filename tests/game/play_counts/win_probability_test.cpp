// The win probability, and what situations are worth.
#include "game/play_counts/win_probability.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "game/play_counts/situation_value.hpp"
#include "soccer/random.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::game {
namespace {

MatchState match(int west, int east, double played_s, double left_s) {
  MatchState match;
  match.goals = {{west, east}};
  match.xg = {{1.0 * west, 1.0 * east}};
  match.robots = {{6, 6}};
  match.played_s = played_s;
  match.left_s = left_s;
  return match;
}

WinModel some_model() { return {"paper", 1.5, 200, 0.5, 0.2}; }

double uniform(RandomStream& random) { return random.uniform(); }

// A number from a Poisson distribution, by Knuth's method.
int poisson(double mean, RandomStream& random) {
  int n = 0;
  for (double product = uniform(random); product > std::exp(-mean); ++n) product *= uniform(random);
  return n;
}

// A number from a gamma distribution with an integer shape.
double gamma(int shape, double rate, RandomStream& random) {
  double sum = 0;
  for (int i = 0; i < shape; ++i) sum -= std::log(1 - uniform(random)) / rate;
  return sum;
}

// West has seen 1 goal and 3 expected goals, which count as 2, and one robot more doubles its rate.
TEST(WinProbability, IsThatOfTheModelsGames) {
  const WinModel model{"paper", 1, 100, 0.5, std::log(2)};
  MatchState now = match(1, 2, 150, 250);
  now.xg[Side::kWest] = 3;
  now.robots = {{6, 5}};
  RandomStream random(5);
  constexpr int kGames = 40'000;
  int west = 0;
  int draws = 0;
  for (int i = 0; i < kGames; ++i) {
    const int goals_of_west = 1 + poisson(2 * 250 * gamma(1 + 2, 100 + 150, random), random);
    const int goals_of_east = 2 + poisson(0.5 * 250 * gamma(1 + 2, 100 + 150, random), random);
    west += goals_of_west > goals_of_east ? 1 : 0;
    draws += goals_of_west == goals_of_east ? 1 : 0;
  }
  const WinProbability p = model.probability(now);
  EXPECT_NEAR(p.west, 1.0 * west / kGames, 0.008);  // three standard errors
  EXPECT_NEAR(p.draw, 1.0 * draws / kGames, 0.008);
  EXPECT_NEAR(p.west + p.draw + p.east, 1, 1e-12);
}

// A spell of play that surely ends in a goal, 7 s before the end: it ends in time in 1 - 1 / e of
// all cases.
TEST(WinProbability, CountsASituationOnlyIfThereIsTimeForIt) {
  const WinModel model{"paper", 1, 1e9, 0, 0};  // no other goals
  MatchState now = match(0, 0, 593, 7);
  now.scores[Side::kWest] = 1;
  EXPECT_NEAR(model.probability(now).west, 1 - std::exp(-1), 1e-6);
}

TEST(WinProbability, IsFiniteAfterManyGoals) {
  const WinModel model{"paper", 0.4, 10, 0, 0};
  const WinProbability p = model.probability(match(400, 390, 1, 1e4));
  EXPECT_NEAR(p.west + p.draw + p.east, 1, 1e-9);
}

TEST(WinProbability, IsTheSameForBothTeams) {
  const WinModel model = some_model();
  MatchState now = match(3, 1, 100, 500);
  now.scores = {{0.1, 0.02}};
  now.robots = {{5, 6}};
  MatchState turned = match(1, 3, 100, 500);
  turned.scores = {{0.02, 0.1}};
  turned.robots = {{6, 5}};
  EXPECT_NEAR(model.probability(now).west, model.probability(turned).east, 1e-12);
  EXPECT_NEAR(model.probability(now).draw, model.probability(turned).draw, 1e-12);
}

TEST(WinProbability, IsCertainAtTheEnd) {
  const WinProbability won = some_model().probability(match(2, 1, 600, 0));
  EXPECT_NEAR(won.west, 1, 1e-3);
  EXPECT_NEAR(some_model().probability(match(1, 1, 600, 0)).draw, 1, 1e-3);
  EXPECT_NEAR(some_model().probability(match(0, 9, 600, -3)).share_of_west(), 0, 1e-3);
}

TEST(WinProbability, KnowsGoalsChancesRobotsAndTheSituation) {
  const WinModel model = some_model();
  const MatchState even = match(0, 0, 300, 300);
  const double share = model.probability(even).share_of_west();
  EXPECT_NEAR(share, 0.5, 1e-9);
  MatchState other = even;
  other.goals[Side::kWest] = 1;
  EXPECT_GT(model.probability(other).share_of_west(), share + 0.1);
  other = even;
  other.xg[Side::kWest] = 1;
  EXPECT_GT(model.probability(other).share_of_west(), share + 0.01);
  other = even;
  other.robots[Side::kEast] = 5;
  EXPECT_GT(model.probability(other).share_of_west(), share + 0.01);
  other = even;
  other.scores[Side::kWest] = 0.5;
  EXPECT_GT(model.probability(other).share_of_west(), share + 0.05);
}

TEST(WinProbability, CountsLeadsThatNobodyCanTurn) {
  EXPECT_NEAR(some_model().probability(match(150, 2, 300, 300)).west, 1, 1e-9);
  EXPECT_NEAR(some_model().probability(match(2, 150, 300, 300)).east, 1, 1e-9);
}

TEST(WinProbability, HasModelsForAllRuleBooks) {
  for (const std::string& rules : rule_book_names()) {
    EXPECT_EQ(win_model(rules).rules, rules);
    EXPECT_EQ(value_model(rules).rules, rules);
    // In an even game, a lead is worth more the less time is left.
    const WinModel& model = win_model(rules);
    EXPECT_GT(model.probability(match(1, 0, 500, 100)).west,
              model.probability(match(1, 0, 100, 500)).west)
        << rules;
  }
}

// West has the ball in front of the east goal, with nobody near.
class ValueScene {
 public:
  explicit ValueScene(double ball_x_m) {
    now.ball.position_m = {ball_x_m, 0};
    put({Side::kWest, 1}, {ball_x_m - 0.15, 0});
  }
  void put(RobotId id, const Vec2& position_m) {
    now.robots[id.side].push_back({id.number, position_m, {1, 0}, {0, 0}, 0});
  }
  SituationValue value(const BallOwner& owner = {Side::kWest}) const {
    return value_model("2014").value(value_features(owner, now, field), owner.shot_chance);
  }
  Field field;
  sim::WorldState now;
};

TEST(SituationValue, HasFeaturesAsSeenByTheOwner) {
  ValueScene scene(2);
  scene.put({Side::kEast, 1}, {2, 0.3});
  scene.put({Side::kWest, 2}, {-3, 0});
  scene.now.ball.velocity_mps = {1, 2};
  const auto features = value_features({Side::kWest}, scene.now, scene.field);
  const double half_m = scene.field.half_length_m();
  EXPECT_EQ(features[0], 1);
  EXPECT_NEAR(features[1], 2 / half_m, 1e-9);
  EXPECT_EQ(features[2], 0);
  EXPECT_EQ(features[3], 0);
  EXPECT_NEAR(features[4], std::exp(-(half_m - 2) / 2), 1e-9);
  EXPECT_GT(features[5], 0.5);
  EXPECT_NEAR(features[6], std::exp(-1), 1e-9);
  EXPECT_NEAR(features[7], std::exp(-0.5), 1e-9);
  EXPECT_NEAR(features[8], 0.25, 1e-9);
  EXPECT_EQ(features[9], 1);
  const auto of_east = value_features({Side::kEast}, scene.now, scene.field);
  EXPECT_NEAR(of_east[1], -2 / half_m, 1e-9);
  EXPECT_NEAR(of_east[8], -0.25, 1e-9);
  EXPECT_EQ(of_east[9], -1);
  const auto penalty = value_features({Side::kWest, true, true}, scene.now, scene.field);
  EXPECT_EQ(penalty, (std::array<double, kValueFeatures>{1, 0, 1, 1, 0, 0, 0, 0, 0, 1}));
}

TEST(SituationValue, GrowsTowardsTheGoal) {
  EXPECT_GT(ValueScene(2).value().scores, 2 * ValueScene(-2).value().scores);
}

TEST(SituationValue, FallsIfTheGoalIsCovered) {
  ValueScene covered(2);
  covered.put({Side::kEast, 1}, {2.2, 0});
  EXPECT_LT(covered.value().scores, ValueScene(2).value().scores);
}

TEST(SituationValue, KnowsShotsOnTheirWayAndPenalties) {
  const ValueScene scene(0);
  BallOwner shooter{Side::kWest};
  shooter.shot_chance = 0.9;
  const SituationValue before = scene.value();
  EXPECT_DOUBLE_EQ(scene.value(shooter).scores, 0.9 + 0.1 * before.scores);
  EXPECT_DOUBLE_EQ(scene.value(shooter).concedes, 0.1 * before.concedes);
  EXPECT_GT(scene.value({Side::kWest, true, true}).scores,
            scene.value({Side::kWest, true, false}).scores + 0.1);
}

TEST(SituationValue, IsTheSameForBothTeams) {
  ValueScene west(1);
  west.put({Side::kEast, 1}, {2, 0.3});
  west.now.ball.velocity_mps = {1, 0.5};
  ValueScene east(-1);
  east.now.robots = {};
  east.put({Side::kEast, 1}, {-0.85, 0});
  east.put({Side::kWest, 1}, {-2, -0.3});
  east.now.ball.velocity_mps = {-1, -0.5};
  EXPECT_NEAR(west.value().scores, east.value({Side::kEast}).scores, 1e-9);
  EXPECT_NEAR(west.value().concedes, east.value({Side::kEast}).concedes, 1e-9);
}

}  // namespace
}  // namespace autoref::game
