#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kFromBall_m = 350_mm;  // distance from the ball to the robot's centre

Vec2 ball_target_m(const RowdyView& view) {
  return view.now.placement_m.value_or(view.now.ball.position_m);
}

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (view.now.play != Play::kStop) return std::nullopt;
  return foul_by(nearest_mate(view, ball_target_m(view), view.field.length_m), ball_target_m(view));
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2 ball_m = ball_target_m(view);
  const Vec2 back = direction_of(view.field.goal_centre_m(Side::kWest) - ball_m, Vec2(-1, 0));
  output.command(foul.robot) =
      go_to(view, *find(view.now.own, foul.robot), ball_m + back * kFromBall_m);
  return view.now.play == Play::kStop;
}

}  // namespace

const FoulBehaviour kStopCrowd = {
    "stop_crowd", "Stands within 500 mm of the ball while play is stopped.", 0.1, 6, find_chance,
    go_on};

}  // namespace autoref::strategies::rowdy
