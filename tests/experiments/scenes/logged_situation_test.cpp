// Situations taken from a log.
#include "experiments/scenes/situation_reader.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/scenario_reader.hpp"
#include "logs/logged_state.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"
#include "tests/support/short_log.hpp"

namespace autoref::experiments {
namespace {

std::string situations_from(const std::string& keys) {
  return "schema: 1\nkind: situations\n"
         "attackers: { one: { strategy: dummy } }\n"
         "defenders: { other: { strategy: dummy } }\n"
         "situations: { logged: { from: { log: game.log.gz, " +
         keys + " } } }\npairs: 1\nseed: 1\n";
}

class LoggedSituation : public testing::Test {
 protected:
  SituationSetup read(const std::string& keys) const {
    const Scenario scenario =
        read_scenario_text(situations_from(keys), (folder_.path() / "x.yaml").string());
    return situations_in(scenario).situations.at("logged");
  }

  TemporaryFolder folder_;
  std::string log_ = write_short_log(folder_, "paper");
  game::StartState logged_start_ = logs::logged_state(log_, 12.5).start;
};

TEST_F(LoggedSituation, HasTheStateOfTheLogBesideTheFile) {
  const SituationSetup situation = read("at_s: 12.5");
  const game::StartState start = drawn_state(situation, "logged", Field{}, 1, 1);
  for (const Side side : kSides) {
    ASSERT_EQ(start.robots[side].size(), logged_start_.robots[side].size());
    for (std::size_t i = 0; i < start.robots[side].size(); ++i) {
      const sim::RobotState& robot = start.robots[side][i];
      EXPECT_LT((robot.position_m - logged_start_.robots[side][i].position_m).norm(), 1e-4);
      EXPECT_LT((robot.velocity_mps - logged_start_.robots[side][i].velocity_mps).norm(), 2e-4);
      EXPECT_GT(robot.heading.dot(logged_start_.robots[side][i].heading), 0.9999);
    }
  }
  EXPECT_EQ(start.referee.restart, logged_start_.referee.restart);
}

TEST_F(LoggedSituation, IsTurnedIfBlueAttacks) {
  const SituationSetup situation = read("at_s: 12.5, attackers: blue");
  EXPECT_NEAR(situation.attackers[0].x_m.first,
              -logged_start_.robots[Side::kEast][0].position_m.x(), 1e-4);
  EXPECT_NEAR(situation.defenders[0].y_m.first,
              -logged_start_.robots[Side::kWest][0].position_m.y(), 1e-4);
}

TEST_F(LoggedSituation, HasASpreadOfItsPositionsOnly) {
  const SituationSetup situation = read("at_s: 12.5, spread_m: 0.01");
  EXPECT_EQ(situation.attackers[0].x_m.kind, Distribution::Kind::kNormal);
  EXPECT_EQ(situation.attackers[0].x_m.second, 0.01);
  EXPECT_EQ(situation.attackers[0].vx_mps.kind, Distribution::Kind::kFixed);
}

TEST_F(LoggedSituation, IsWrittenWithItsNumbersSoThatTheLogIsNotNeeded) {
  const Scenario scenario =
      read_scenario_text(situations_from("at_s: 12.5"), (folder_.path() / "x.yaml").string());
  const std::string text = effective_text(scenario);
  EXPECT_EQ(text.find("game.log"), std::string::npos);
  EXPECT_EQ(effective_text(read_scenario_text(text, "elsewhere/effective.yaml")), text);
}

}  // namespace
}  // namespace autoref::experiments
