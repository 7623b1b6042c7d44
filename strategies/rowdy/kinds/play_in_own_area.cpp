#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kDeep_m =
    150_mm;  // a robot behind a ball this deep in the area is entirely inside
constexpr double kReach_m = 2.0;
constexpr double kSlow_mps = 1.2;
// Distance from the goal line to the ball, so that a robot fits between.
constexpr double kOffGoal_m = 250_mm;
constexpr double kKick_mps = 2.0;
constexpr double kKicked_mps = 1.5;

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  const TrackedBall& ball = view.now.ball;
  const bool is_deep =
      distance_to_defence_area(view.field, Side::kWest, ball.position_m) < -kDeep_m &&
      ball.position_m.x() > -view.field.half_length_m() + kOffGoal_m;
  if (!is_running(view) || !is_deep || ball.velocity_mps.norm() > kSlow_mps) return std::nullopt;
  return foul_by(nearest_mate(view, ball.position_m, kReach_m), ball.position_m);
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2& ball_m = view.now.ball.position_m;
  hold_back(view, foul.robot, ball_m, kReach_m, output.commands);
  output.command(foul.robot) =
      kick_at(view, *find(view.now.own, foul.robot), ball_m + Vec2(1, 0), kKick_mps);
  return is_running(view) && view.now.ball.velocity_mps.norm() < kKicked_mps;
}

}  // namespace

const FoulBehaviour kPlayInOwnArea = {"play_in_own_area",
                                      "A field player entirely inside its own area plays the ball.",
                                      0.6,
                                      5,
                                      find_chance,
                                      go_on};

}  // namespace autoref::strategies::rowdy
