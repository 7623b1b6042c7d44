#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kFromBall_m = 300_mm;  // distance from the ball to the robot's centre

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_opponents_restart(view)) return std::nullopt;
  return foul_by(nearest_mate(view, view.now.ball.position_m, view.field.length_m),
                 view.now.ball.position_m);
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2& ball_m = view.now.ball.position_m;
  const Vec2 back = direction_of(view.field.goal_centre_m(Side::kWest) - ball_m, Vec2(-1, 0));
  output.command(foul.robot) =
      go_to(view, *find(view.now.own, foul.robot), ball_m + back * kFromBall_m);
  return is_opponents_restart(view);
}

}  // namespace

const FoulBehaviour kCrowdRestart = {"crowd_restart",
                                     "Stands within 500 mm of the ball at the opponents' restarts.",
                                     0.15,
                                     12,
                                     find_chance,
                                     go_on};

}  // namespace autoref::strategies::rowdy
