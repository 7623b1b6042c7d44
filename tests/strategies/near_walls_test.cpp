// Teams on fields whose walls stand 0.3 m from the lines (2026).
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "strategies/registry.hpp"
#include "strategies/tactics/place_ball.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

// Keeps robots between the walls, which the staged world lacks.
void stop_at_walls(const Field& field, TrackedRobots& robots) {
  const Vec2 farthest_m(field.wall_x_m() - kRobotRadius_m, field.wall_y_m() - kRobotRadius_m);
  for (TrackedRobot& robot : robots)
    robot.position_m = robot.position_m.cwiseMax(-farthest_m).cwiseMin(farthest_m);
}

StagedWorld on_large_field(Play play) {
  StagedWorld world(play);
  for (int i = 0; i < 6; ++i)
    world.own(i, {-0.6 - 0.6 * i, 1.5 - 0.5 * i}).opponent(i, {3, 0.4 * i});
  return world;
}

class EveryTeamNearAWall : public testing::TestWithParam<std::string_view> {};

// A ball 0.2 m inside the touch line, as for a throw-in; between it and the wall are 0.41 m for a
// robot's centre.
TEST_P(EveryTeamNearAWall, LeavesTheGapBetweenTheOpponentsBallAndTheWall) {
  const TeamContext context = team_context_of("2026-b");
  const auto team = find_strategy(GetParam())->make(context);
  const Vec2 ball_m(-1, -2.8);
  for (const double aside_m : {-0.2, 0.0, 0.3}) {
    StagedWorld world = on_large_field(Play::kDirectFree);
    world.ball(ball_m).view.own[3].position_m = {-1 + aside_m, -3.15};
    for (int f = 0; f < 240; ++f) {
      world.step(*team);
      stop_at_walls(context.field, world.view.own);
    }
    EXPECT_GE((world.robot(3).position_m - ball_m).norm(), kBallGap_m) << aside_m;
  }
}

std::vector<std::string_view> lawful_teams_near_walls() {
  std::vector<std::string_view> names;
  for (const Entry& entry : all_strategies())
    if (entry.name != "dummy" && entry.name != "rowdy") names.push_back(entry.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Named, EveryTeamNearAWall, testing::ValuesIn(lawful_teams_near_walls()),
                         [](const auto& team) { return std::string(team.param); });

// Lets robot 1 place the ball at that point, where it lies, until the robot has set it down and
// backed away from it, standing on that side of it. Returns the robot's distance from the ball.
double backed_away_m(const Vec2& ball_m, const Vec2& from) {
  const TeamContext context = team_context_of("2026-b");
  StagedPrediction stage(Play::kStop, false, context);
  TeamView& view =
      stage.world.own(0, {-4, 0}).own(1, ball_m + from * kHeldBall_m).ball(ball_m).view;
  view.own[1].heading = -from;
  view.placement_m = ball_m;
  view.placing_is_ours = true;
  view.next = CommandKind::kForceStart;
  BallPlacer placer(stage.predicted);
  for (int f = 0; f < 360; ++f) {
    // Noise shows that the cameras see the ball.
    view.ball.position_m = ball_m + Vec2(f % 2 * 1e-5, 0);
    stage.look(1);
    placer.update(view.ball);
    if (placer.index() != 1) continue;
    obey(view.own[1], placer.play());
    stop_at_walls(context.field, view.own);
  }
  return (view.own[1].position_m - ball_m).norm();
}

// Before a force start robots must be 0.5 m from the ball.
TEST(BallPlacer, BacksAwayAlongTheWallIfItIsTooNear) {
  EXPECT_GT(backed_away_m({1, 0}, {0, 1}), kBallGap_m + kBallRadius_m);
  EXPECT_GT(backed_away_m({1, 2.8}, {0, 1}), kBallGap_m + kBallRadius_m);
  EXPECT_GT(backed_away_m({4.3, -2.8}, heading_of(-kPi / 4)), kBallGap_m + kBallRadius_m);
}

TEST(ExitFromBehindGoal, LeadsNowhereBehindAGoalThatReachesTheWall) {
  const Field field = team_context_of("2026-a").field;
  const double behind_m = field.half_length_m() + 0.35;
  EXPECT_FALSE(exit_from_behind_goal(field, {behind_m, 0.2}));
  const Vec2 beside_m(behind_m, field.half_goal_m() + field.goal_wall_thickness_m + 0.1);
  EXPECT_LT(exit_from_behind_goal(field, beside_m).value().x(), field.half_length_m());
}

}  // namespace
}  // namespace autoref::strategies
