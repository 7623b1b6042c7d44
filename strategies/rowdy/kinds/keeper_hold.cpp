#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

// Minimum distance from the ball to the area's edge and to the goal line.
constexpr double kInside_m = 200_mm;
constexpr double kSlow_mps = 1.5;
constexpr double kReach_m = 1.2;
constexpr double kBehind_m = kFrontDistance_m + kBallRadius_m + 20_mm;
constexpr double kThere_m = 30_mm;
constexpr double kApproach_mps = 0.2;
// The keeper sways, because otherwise the ball would count as stuck.
constexpr double kSway_mps = 0.1;
constexpr double kSway_s = 3.0;  // time in each direction
constexpr double kShortest_s = 4;
constexpr double kLongest_s = 18;

bool is_held(const RowdyView& view) {
  const Vec2& ball_m = view.now.ball.position_m;
  return distance_to_defence_area(view.field, Side::kWest, ball_m) < 0 &&
         ball_m.x() > -view.field.half_length_m();
}

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  const TrackedBall& ball = view.now.ball;
  const bool is_inside =
      distance_to_defence_area(view.field, Side::kWest, ball.position_m) < -kInside_m &&
      ball.position_m.x() > -view.field.half_length_m() + kInside_m;
  const TrackedRobot* keeper = find(view.now.own, view.keeper);
  if (!is_running(view) || !is_inside || ball.velocity_mps.norm() > kSlow_mps ||
      keeper == nullptr || (keeper->position_m - ball.position_m).norm() > kReach_m) {
    return std::nullopt;
  }
  return foul_by(keeper, ball.position_m);
}

RobotCommand fetch(const RowdyView& view, const TrackedRobot& keeper) {
  const Vec2 behind_m = view.now.ball.position_m - Vec2(kBehind_m, 0);
  if ((keeper.position_m - behind_m).norm() < kThere_m) {
    return drive_with(keeper, Vec2(kApproach_mps, 0), Vec2(1, 0), {});
  }
  return drive_to(keeper, {behind_m, Vec2(1, 0)}, {}, {});
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const TrackedRobot& keeper = *find(view.now.own, foul.robot);
  const double lasts_s = view.now.time_s - foul.begun_s;
  RobotCommand& command = output.command(foul.robot);
  if (has_ball(keeper, view.now.ball)) {
    const bool is_forth = static_cast<int>(lasts_s / kSway_s) % 2 == 0;
    command = drive_with(keeper, Vec2(is_forth ? kSway_mps : -kSway_mps, 0), Vec2(1, 0), {});
  } else {
    command = fetch(view, keeper);
  }
  command.dribble = true;
  return is_running(view) && is_held(view) &&
         lasts_s < kShortest_s + (kLongest_s - kShortest_s) * foul.amount;
}

}  // namespace

const FoulBehaviour kKeeperHold = {
    "keeper_hold", "The keeper holds the ball in its area for 4 to 18 s.", 0.6, 22, find_chance,
    go_on};

}  // namespace autoref::strategies::rowdy
