#include "strategies/rowdy/foul_behaviours.hpp"
#include "strategies/skills/openings.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kNear_m = 500_mm;
constexpr double kBehindHalfway_m = 200_mm;  // distance from the ball to the halfway line
constexpr double kAimShare = 0.7;            // fraction of half the field's width
constexpr double kKick_mps = 6.4;            // below every rule book's limit
constexpr double kKicked_mps = 3.0;

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  const Vec2& ball_m = view.now.ball.position_m;
  const bool is_free = is_running(view) || (view.now.ours && is_free_kick(view.now.play));
  if (!is_free || ball_m.x() > -kBehindHalfway_m) return std::nullopt;
  return foul_by(nearest_mate(view, ball_m, kNear_m), ball_m);
}

// Aims beside the goal, on the side with more space.
bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2& ball_m = view.now.ball.position_m;
  const Vec2 left_m(view.field.half_length_m(), kAimShare * view.field.half_width_m());
  const Vec2 right_m(left_m.x(), -left_m.y());
  const bool is_left_clearer = lane_clearance_m(ball_m, left_m, view.now.opponents) >
                               lane_clearance_m(ball_m, right_m, view.now.opponents);
  const Vec2 target_m = is_left_clearer ? left_m : right_m;
  clear_lane(view, foul.robot, ball_m, target_m, output.commands);
  output.command(foul.robot) = kick_at(view, *find(view.now.own, foul.robot), target_m, kKick_mps);
  return view.now.ball.velocity_mps.norm() < kKicked_mps;
}

}  // namespace

const FoulBehaviour kAimlessKick = {
    "aimless_kick", "Shoots over the opponents' goal line from its own half.", 0.1, 4, find_chance,
    go_on};

}  // namespace autoref::strategies::rowdy
