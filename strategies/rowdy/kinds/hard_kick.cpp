#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kHardest_mps = 10;
constexpr double kNear_m = 300_mm;  // distance from the ball to a robot that may soon kick
constexpr double kKicked_mps = 5;

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_running(view) && !is_own_restart(view)) return std::nullopt;
  return foul_by(nearest_mate(view, view.now.ball.position_m, kNear_m), view.now.ball.position_m);
}

// The team plays normally, but its kicks are harder.
bool go_on(const RowdyView& view, ActiveFoul& /*foul*/, TeamOutput& output) {
  for (RobotCommand& command : output.commands) {
    if (command.kick_mps > 0) command.kick_mps = kHardest_mps;
  }
  return view.now.ball.velocity_mps.norm() < kKicked_mps &&
         (is_running(view) || is_own_restart(view));
}

}  // namespace

const FoulBehaviour kHardKick = {
    "hard_kick", "Kicks as hard as the kicker can, up to 10 m/s.", 0.1, 4, find_chance, go_on};

}  // namespace autoref::strategies::rowdy
