// A possession team. While it has the ball, its robots form a net around the ball, and a short pass
// can reach each of them. Otherwise, the team defends like cobalt.
#include <algorithm>

#include "soccer/trigonometry.hpp"
#include "strategies/plays/formation_spots.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {
namespace {

Vec2 on_field(const PredictedState& predicted, const Vec2& p) {
  const double from_edge_m = predicted.style().net_from_edge_m;
  const double x_m = predicted.field().half_length_m() - from_edge_m;
  const double y_m = predicted.field().half_width_m() - from_edge_m;
  return {std::clamp(p.x(), -x_m, x_m), std::clamp(p.y(), -y_m, y_m)};
}

// The position for the safest pass from the ball, roughly in the given direction. It is the best of
// six candidates, in three directions and at two distances.
Waypoint knot(const PredictedState& predicted, const Vec2& direction) {
  const Vec2& ball_m = predicted.position_m();
  const double net_m = predicted.style().net_m;
  Waypoint best;
  double best_score = -1e9;
  for (const double aside : {0.0, 1.0, -1.0}) {
    const Vec2 bent = to_world(heading_of(aside * predicted.style().net_aside_rad), direction);
    for (const double reach : {1.0, predicted.style().net_nearest}) {
      const Vec2 wanted_m = on_field(predicted, ball_m + bent * (reach * net_m));
      const Waypoint waypoint = off_their_area(predicted, wanted_m);
      const double near =
          1 - (waypoint.position_m - ball_m).norm() / (predicted.style().net_nearest * net_m);
      const double score = pass_safety(ball_m, waypoint.position_m, predicted.style().net_pass_mps,
                                       predicted.now().opponents) +
                           (aside == 0 && reach == 1 ? predicted.style().net_centre_bonus : 0) -
                           predicted.style().net_too_near * std::max(0.0, near);
      if (score <= best_score) continue;
      best_score = score;
      best = waypoint;
    }
  }
  return best;
}

// The net is evenly spread around the ball, and open towards the team's own goal, where the
// defender stands.
void spread_net(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  const int count = assignment.free_robots();
  const Vec2 goal_m = predicted.field().goal_centre_m(Side::kEast);
  const Vec2 ahead = direction_of(goal_m - predicted.position_m(), Vec2(1, 0));
  const double step_rad = std::min(predicted.style().net_widest_rad, 2 * kPi / std::max(count, 1));
  FormationSpots knots;
  for (int i = 0; i < count; ++i) {
    const double turn_rad = step_rad * (i - (count - 1) / 2.0);
    knots.push_back({i + 1, knot(predicted, to_world(heading_of(turn_rad), ahead))});
  }
  fill_spots(book, assignment, knots);
}

void possession_play(PlayContext& book, RoleAssignment& assignment) {
  if (!book.predicted.is_ours()) return open_play(book, assignment);
  give_goal_and_ball(book, assignment);
  defend(book, assignment, assignment.free_robots() > 2 ? 1 : 0, 0);
  spread_net(book, assignment);
}

void await_possession(PlayContext& book, RoleAssignment& assignment) {
  if (!book.predicted.restart_is_ours()) return await_restart(book, assignment);
  give_goal_and_restart(book, assignment);
  defend(book, assignment, assignment.free_robots() > 2 ? 1 : 0, 0);
  spread_net(book, assignment);
}

}  // namespace

TeamPlaybook possession_playbook() {
  Style style;
  style.shot_threshold = 0.2;
  style.pass_arrival_mps = 1.4;
  style.pass_risk = 0.1;
  style.patience = 0.15;
  style.carry = 0.4;
  return {style, possession_play, await_possession};
}

}  // namespace autoref::strategies
