#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kKick_mps = 4.0;
constexpr double kRolls_mps = 0.3;

std::optional<ActiveFoul> find_chance(const Scene& scene) {
  const Vec2& ball_m = scene.now.ball.position_m;
  if (!scene.now.ours || !is_free_kick(scene.now.play) || ball_m.x() > 0) return std::nullopt;
  return foul_by(nearest_mate(scene, ball_m, scene.field.length_m), ball_m);
}

// The kicker's team-mates stay out of the way until the ball is in the goal.
bool go_on(const Scene& scene, ActiveFoul& foul, TeamOutput& output) {
  const Vec2& ball_m = scene.now.ball.position_m;
  const Vec2 goal_m = scene.field.goal_centre_m(Side::kWest);
  clear_lane(scene, foul.robot, ball_m, goal_m, output.commands);
  if (is_running(scene)) {
    output.command(foul.robot) = RobotCommand{};
    return scene.now.ball.velocity_mps.norm() > kRolls_mps;
  }
  output.command(foul.robot) = kick_at(scene, *find(scene.now.own, foul.robot), goal_m, kKick_mps);
  return scene.now.ours && is_free_kick(scene.now.play);
}

}  // namespace

const FoulBehaviour kOwnGoalKick = {"own_goal_kick",
                                    "Plays a free kick in its own half back into its own goal.",
                                    0.2,
                                    10,
                                    find_chance,
                                    go_on};

}  // namespace autoref::strategies::rowdy
