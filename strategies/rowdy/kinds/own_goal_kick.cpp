#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kKick_mps = 4.0;
constexpr double kRolls_mps = 0.3;

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  const Vec2& ball_m = view.now.ball.position_m;
  if (!view.now.ours || !is_free_kick(view.now.play) || ball_m.x() > 0) return std::nullopt;
  return foul_by(nearest_mate(view, ball_m, view.field.length_m), ball_m);
}

// The kicker's team-mates stay out of the way until the ball is in the goal.
bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2& ball_m = view.now.ball.position_m;
  const Vec2 goal_m = view.field.goal_centre_m(Side::kWest);
  clear_lane(view, foul.robot, ball_m, goal_m, output.commands);
  if (is_running(view)) {
    output.command(foul.robot) = RobotCommand{};
    return view.now.ball.velocity_mps.norm() > kRolls_mps;
  }
  output.command(foul.robot) = kick_at(view, *find(view.now.own, foul.robot), goal_m, kKick_mps);
  return view.now.ours && is_free_kick(view.now.play);
}

}  // namespace

const FoulBehaviour kOwnGoalKick = {"own_goal_kick",
                                    "Plays a free kick in its own half back into its own goal.",
                                    0.2,
                                    10,
                                    find_chance,
                                    go_on};

}  // namespace autoref::strategies::rowdy
