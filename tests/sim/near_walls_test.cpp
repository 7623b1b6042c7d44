// Fields whose walls stand near the lines, and whose goals' side walls go on to them (2026).
#include <gtest/gtest.h>

#include <string>

#include "soccer/rules/rule_book.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

Field field_of_book(const char* name) { return find_game_setup(name)->field; }

class FieldOf2026 : public testing::TestWithParam<const char*> {
 public:
  FieldOf2026() : field(field_of_book(GetParam())), world(field, quiet(), specs(1, 1), 1) {}

  // The ball after that time; it starts at that point.
  BallState ball_after(double seconds, const BallState& ball) {
    world.put_ball(ball);
    for (int f = 0; f < seconds * 60; ++f) world.step(commands, placement);
    return world.state().ball;
  }
  double outer_m() const { return field.half_goal_m() + field.goal_wall_thickness_m; }

  Field field;
  World world;
  PerSide<TeamCommands> commands{};
  std::optional<Placement> placement;
};

TEST_P(FieldOf2026, HasAWallThatSendsTheBallBackOverTheTouchLine) {
  BallState ball;
  ball.position_m = {1, field.half_width_m() - 0.1};
  ball.velocity_mps = {0, 6};
  EXPECT_LT(ball_after(1.5, ball).position_m.y(), field.half_width_m());
}

TEST_P(FieldOf2026, HasNoWayBehindAGoalForTheBall) {
  BallState ball;
  ball.position_m = {field.wall_x_m() - 0.05, outer_m() + 0.3};
  ball.velocity_mps = {0, -4};
  const Vec2 position_m = ball_after(2, ball).position_m;
  EXPECT_GT(position_m.y(), outer_m());
}

TEST_P(FieldOf2026, HasNoWayBehindAGoalForARobot) {
  const Vec2 beside_m(field.wall_x_m() - 0.1, outer_m() + 0.3);
  world.put_robot(kWest0, {0, beside_m, Vec2(0, -1), Vec2(0, 0), 0.0});
  commands[Side::kWest][0].velocity_mps = {2, 0};
  ball_after(2, {});
  EXPECT_GT(world.state().robots[Side::kWest][0].position_m.y(), outer_m() + kRobotRadius_m - 2_mm);
}

// The hand lifts the ball over the walls.
TEST_P(FieldOf2026, LetsTheRefereeTakeTheBallFromBehindAGoal) {
  BallState ball;
  ball.position_m = {field.wall_x_m() - 0.04, 0.1};
  placement = Placement{{0, 0.5}, false};
  EXPECT_LT((ball_after(8, ball).position_m - Vec2(0, 0.5)).norm(), 1e-3);
}

TEST_P(FieldOf2026, LetsNoBallRestOnASideWall) {
  for (int i = 0; i <= 4; ++i) {
    BallState ball;
    const double share = i / 4.0;
    ball.position_m = {field.half_length_m() + 0.22 + share * (field.behind_goal_lines_m() - 0.25),
                       field.half_goal_m() + field.goal_wall_thickness_m / 2};
    ball.height_m = 0.4;
    const BallState after = ball_after(4, ball);
    EXPECT_EQ(after.height_m, 0.0) << i;
    EXPECT_GT(after.position_m.y(), outer_m() + kBallRadius_m - 3_mm) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Divisions, FieldOf2026, testing::Values("2026-b", "2026-a"),
                         [](const auto& book) {
                           return std::string(book.param) == "2026-b" ? "B" : "A";
                         });

// The message about the field if its goals are that deep; empty if it is accepted.
std::string refused_depth(Field field, double depth_m) {
  field.goal_depth_m = depth_m;
  try {
    validate(field);
  } catch (const OutOfRange& error) {
    return error.what();
  }
  return "";
}

TEST(FieldSizes, LetAGoalReachTheWallButNotGoThroughIt) {
  EXPECT_EQ(refused_depth(field_of_book("2026-b"), 0.28), "");
  EXPECT_EQ(refused_depth(field_of_book("2026-b"), 0.281),
            "field.goal_depth_m is 0.281; it must be at most 0.28, because the wall stands 0.3 m "
            "behind the goal line (field.run_off_m) and the goal's back is 0.02 m thick");
  EXPECT_EQ(refused_depth(field_of_book("2026-a"), 0.58), "");
  EXPECT_NE(refused_depth(field_of_book("2026-a"), 0.59).find("field.goal_line_run_off_m"),
            std::string::npos);
}

TEST(FieldSizes, LeaveRoomForARobotBetweenLineAndWall) {
  Field field;
  field.goal_depth_m = 0.1;
  field.run_off_m = 0.18;
  EXPECT_NO_THROW(validate(field));
  field.run_off_m = 0.17;
  EXPECT_THROW(validate(field), OutOfRange);
  field = {};
  field.goal_depth_m = 0.1;
  field.goal_line_run_off_m = 0.17;
  EXPECT_THROW(validate(field), OutOfRange);
}

}  // namespace
}  // namespace autoref::sim
