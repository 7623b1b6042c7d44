// Play counts of whole games: their consistency and their symmetry between the sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>

#include "game/loop/game.hpp"
#include "game/play_counts/play_statistics.hpp"
#include "sim/presets.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

sim::WorldState turned(const sim::WorldState& state) {
  sim::WorldState turned = state;
  std::swap(turned.robots[Side::kWest], turned.robots[Side::kEast]);
  for (const Side side : kSides) {
    for (sim::RobotState& robot : turned.robots[side]) {
      robot.position_m = -robot.position_m;
      robot.heading = -robot.heading;
      robot.velocity_mps = -robot.velocity_mps;
    }
  }
  turned.ball.position_m = -state.ball.position_m;
  turned.ball.velocity_mps = -state.ball.velocity_mps;
  return turned;
}

// Sorts touches as the rotated world would report them: in each sub-step, kicks come before hull
// contacts and west before east.
std::vector<sim::Touch> turned(std::span<const sim::Touch> touches) {
  std::vector<sim::Touch> turned(touches.begin(), touches.end());
  for (sim::Touch& touch : turned) {
    touch.robot.side = opponent_of(touch.robot.side);
    touch.ball_m = -touch.ball_m;
    touch.ball_mps = -touch.ball_mps;
  }
  std::stable_sort(turned.begin(), turned.end(), [](const sim::Touch& a, const sim::Touch& b) {
    return std::tuple(a.substep, !a.is_kick, a.robot) < std::tuple(b.substep, !b.is_kick, b.robot);
  });
  return turned;
}

referee::Decision turned(referee::Decision decision) {
  if (decision.command) decision.command = mirrored(*decision.command);
  if (decision.finding.offender)
    decision.finding.offender = opponent_of(*decision.finding.offender);
  decision.finding.restart = mirrored(decision.finding.restart);
  return decision;
}

// Counts plays twice during the game: once as it is, and once with the field rotated by 180
// degrees. The ball counts as in play from the restart's signal.
class Counters final : public Observer {
 public:
  explicit Counters(const GameConfiguration& game)
      : upright(game.field, game.sim.ball, game.sim.frame_rate_hz,
                chance_model(game.match.rules.name), value_model(game.match.rules.name)),
        upside_down(upright) {}

  void on_decision(const referee::Decision& decision) override {
    decisions_.push_back(decision);
    turned_decisions_.push_back(turned(decision));
    is_on_ = decision.to == referee::State::kRun;
    if (!is_on_) stopped_.insert(decision.frame);
  }
  void on_action(const BallAction& action) override {
    if (action.kind == ActionKind::kFoul) return;
    if (last_action_frame_ && !stopped_.contains(*last_action_frame_)) {
      EXPECT_EQ(action.first_frame, *last_action_frame_) << "a gap between two actions";
    }
    last_action_frame_ = action.last_frame;
  }
  void on_frame(const Frame&, const RefereeSignal&, const sim::World& world) override {
    if (!world.touches().empty()) touched_ = world.touches().back().robot.side;
    for (const referee::Decision& decision : decisions_) note_own_goal(decision);
    upright.update({world.state(), world.touches(), decisions_, is_on_, is_on_});
    const std::vector<sim::Touch> touches = turned(world.touches());
    upside_down.update({turned(world.state()), touches, turned_decisions_, is_on_, is_on_});
    decisions_.clear();
    turned_decisions_.clear();
  }

  PlayStatistics upright;
  PlayStatistics upside_down;
  PerSide<int> own_goals;  // goals of a side that did not touch the ball last

 private:
  void note_own_goal(const referee::Decision& decision) {
    if (decision.finding.event != referee::Event::kGoal) return;
    if (scorer_in(decision) != touched_) ++own_goals[*scorer_in(decision)];
  }

  bool is_on_ = false;
  std::set<std::int64_t> stopped_;  // frames of decisions that stopped play
  std::optional<std::int64_t> last_action_frame_;
  Side touched_ = Side::kWest;
  std::vector<referee::Decision> decisions_;
  std::vector<referee::Decision> turned_decisions_;
};

struct Setup {
  const char* book;
  const char* camera;
  const char* team;
};

// The team's possession chains in all.
ChainCounts all_chains(const PlayCounts& team) {
  ChainCounts all;
  for (const ChainCounts& some : team.by_start) {
    all.chains += some.chains;
    all.shots += some.shots;
    all.goals += some.goals;
    all.xg += some.xg;
  }
  return all;
}

// The angles of a turned goal may be rounded differently.
void expect_near_and_copy_worths(const PlayCounts& from, PlayCounts& to) {
  for (std::size_t kind = 0; kind < kActionKindCount; ++kind) {
    EXPECT_NEAR(to.by_action[kind].worth, from.by_action[kind].worth, 1e-9);
    to.by_action[kind].worth = from.by_action[kind].worth;
  }
}

class PlayCountsOfGames : public testing::TestWithParam<Setup> {
 protected:
  static GameConfiguration game(std::uint64_t seed) {
    GameConfiguration game = short_game_by(GetParam().book, 120, seed);
    game.a.strategy = GetParam().team;
    game.b.strategy = "basic";
    sim::apply_camera_preset(GetParam().camera, game.sim);
    return game;
  }
};

TEST_P(PlayCountsOfGames, AreConsistent) {
  for (std::uint64_t seed = 21; seed <= 22; ++seed) {
    const GameConfiguration configuration = game(seed);
    Counters counters(configuration);
    const GameRecord record = play(configuration, &counters);
    double possession_s = 0;
    for (const PlayCounts& team : record.counts) {
      EXPECT_LE(team.passes_completed, team.passes_tried);
      EXPECT_LE(team.shots_on_goal, team.shots);
      possession_s += team.possession_s;
      EXPECT_EQ(all_chains(team).shots, team.shots);
      EXPECT_LE(team.with_pass.chains, all_chains(team).chains);
      EXPECT_LE(team.with_pass.shots, all_chains(team).shots);
      EXPECT_LE(team.with_pass.xg, all_chains(team).xg + 1e-9);
      EXPECT_LE(team.with_pass.goals, all_chains(team).goals);
      EXPECT_NEAR(all_chains(team).xg, team.xg, 1e-9);
      EXPECT_GT(counts_of(team, ActionKind::kDribble).actions, 0);
      EXPECT_LE(counts_of(team, ActionKind::kShot).actions, team.shots);
      EXPECT_GE(counts_of(team, ActionKind::kPass).actions, team.passes_completed);
      EXPECT_LE(counts_of(team, ActionKind::kFoul).actions, team.fouls);
    }
    EXPECT_EQ(all_chains(record.counts[0]).goals + record.counts[1].own_goals, record.goals_a);
    EXPECT_EQ(all_chains(record.counts[1]).goals + record.counts[0].own_goals, record.goals_b);
    EXPECT_LE(possession_s, record.ball_in_play_s + 1e-6);
    EXPECT_GT(possession_s, 0.5 * record.ball_in_play_s);
    EXPECT_LE(record.goals_a, record.counts[0].shots_on_goal + counters.own_goals[Side::kWest]);
    EXPECT_LE(record.goals_b, record.counts[1].shots_on_goal + counters.own_goals[Side::kEast]);
  }
}

TEST_P(PlayCountsOfGames, AreSwappedIfTheFieldIsRotated) {
  const GameConfiguration configuration = game(23);
  Counters counters(configuration);
  play(configuration, &counters);
  const PerSide<PlayCounts> counts = counters.upright.counts();
  PerSide<PlayCounts> others = counters.upside_down.counts();
  for (const Side side : kSides)
    expect_near_and_copy_worths(counts[side], others[opponent_of(side)]);
  EXPECT_EQ(counts[Side::kWest], others[Side::kEast]);
  EXPECT_EQ(counts[Side::kEast], others[Side::kWest]);
  EXPECT_GT(counts[Side::kWest].shots + counts[Side::kEast].shots, 0) << "nothing was compared";
}

TEST_P(PlayCountsOfGames, EqualThoseOfTheGameLoop) {
  const GameConfiguration configuration = game(24);
  Counters counters(configuration);
  const GameRecord record = play(configuration, &counters);
  for (const Side side : kSides) {
    PlayCounts own = counters.upright.counts()[side];
    const PlayCounts& recorded = record.counts[side == configuration.match.a_plays ? 0 : 1];
    own.possession_s = recorded.possession_s;  // in the game, the ball is in play after the signal
    EXPECT_EQ(recorded, own);
  }
}

std::string name_of_setup(const testing::TestParamInfo<Setup>& info) {
  std::string name =
      std::string("Rules") + info.param.book + "_" + info.param.camera + "_" + info.param.team;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Books, PlayCountsOfGames,
                         testing::Values(Setup{"paper", "paper", "basic"},
                                         Setup{"2014", "paper", "rowdy"},
                                         Setup{"2014-double", "realistic", "basic"},
                                         Setup{"2026-b", "realistic", "rowdy"},
                                         Setup{"2026-a", "paper", "rowdy"}),
                         name_of_setup);

TEST(PlayCountsOfAGame, HaveMoreFoulsForARowdyTeam) {
  GameConfiguration game = short_game_by("2026-b", 120, 25);
  game.a.strategy = "rowdy";
  const GameRecord record = play(game);
  EXPECT_GT(record.counts[0].fouls, record.counts[1].fouls);
}

TEST(PlayCountsOfAGame, ExcludeTheShootout) {
  GameConfiguration game = short_game(5, 1);
  game.match.knockout = true;
  game.match.rules.extra_half_s = 5;
  Counters with_shootout(game);
  const GameRecord record = play(game, &with_shootout);
  ASSERT_TRUE(record.shootout);
  const PerSide<PlayCounts> all = with_shootout.upright.counts();
  EXPECT_LT(record.counts[0].shots + record.counts[1].shots,
            all[Side::kWest].shots + all[Side::kEast].shots);
}

}  // namespace
}  // namespace autoref::game
