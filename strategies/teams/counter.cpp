// A counter-attacking team. All but one or two robots stay behind the ball: a wall in front of the
// team's own area, and a row ahead of it. The ball is immediately played far ahead to the forwards.
#include <algorithm>
#include <cmath>

#include "strategies/plays/formation_spots.hpp"
#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {
namespace {

// A row across the field behind the ball.
void hold_row(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  const Field& field = predicted.field();
  const Vec2& ball_m = predicted.position_m();
  const int count = assignment.free_robots();
  const double x_m = std::clamp(ball_m.x() - predicted.style().row_behind_ball_m,
                                predicted.style().row_deepest * field.half_length_m(),
                                predicted.style().row_farthest * field.half_length_m());
  const double step_m =
      std::min(predicted.style().row_apart_m, 1.6 * field.half_width_m() / std::max(count, 1));
  const double room_m = field.half_width_m() - step_m * count / 2;
  const double middle_m = std::clamp(predicted.style().row_with_ball * ball_m.y(), -room_m, room_m);
  FormationSpots row;
  for (int i = 0; i < count; ++i) {
    const double aside_m = step_m * (i - (count - 1) / 2.0);
    row.push_back({i + 1, facing_ball(predicted, {x_m, middle_m + aside_m})});
  }
  fill_spots(book, assignment, row);
}

// Forwards come first, so that they are ahead when the ball is won.
void block(PlayContext& book, RoleAssignment& assignment) {
  const Style& style = book.predicted.style();
  const bool attacks = book.predicted.is_ours();
  const int left = assignment.free_robots();
  const int wanted = static_cast<int>(std::lround(attacks ? style.receivers : style.forwards));
  const int share =
      left / static_cast<int>(std::lround(style.robots_per_forward)) + (attacks ? 1 : 0);
  const int ahead = std::clamp(std::min(wanted, share), 0, left);
  send_ahead(book, assignment, ahead);
  defend(book, assignment, static_cast<int>(std::lround(style.wall)), 0);
  hold_row(book, assignment);
}

void counter_play(PlayContext& book, RoleAssignment& assignment) {
  give_goal_and_ball(book, assignment);
  block(book, assignment);
}

void await_counter(PlayContext& book, RoleAssignment& assignment) {
  give_goal_and_restart(book, assignment);
  block(book, assignment);
}

}  // namespace

TeamPlaybook counter_playbook() {
  Style style;
  style.ahead = 0.8;
  style.carry = 0.2;
  style.pass_arrival_mps = 2.6;
  style.pass_risk = 0.9;
  style.forwards = 2;
  style.receivers = 2;
  style.line_m = 0.6;
  return {style, counter_play, await_counter};
}

}  // namespace autoref::strategies
