// Counter-attack. All but one or two stay behind the ball, in a wall before the own area and a row
// ahead of it; the ball goes from there to those ahead, long and at once.
#include <algorithm>
#include <cmath>

#include "strategies/plays/posts.hpp"
#include "strategies/teams/plans.hpp"

namespace autoref::strategies {
namespace {

// A row across the field behind the ball.
void hold_row(Playbook& book, Cast& cast) {
  const Outlook& outlook = book.outlook;
  const Field& field = outlook.field();
  const Vec2& ball_m = outlook.place_m();
  const int count = cast.free_robots();
  const double x_m = std::clamp(ball_m.x() - outlook.style().row_behind_ball_m,
                                outlook.style().row_deepest * field.half_length_m(),
                                outlook.style().row_farthest * field.half_length_m());
  const double step_m =
      std::min(outlook.style().row_apart_m, 1.6 * field.half_width_m() / std::max(count, 1));
  const double room_m = field.half_width_m() - step_m * count / 2;
  const double middle_m = std::clamp(outlook.style().row_with_ball * ball_m.y(), -room_m, room_m);
  Posts row;
  for (int i = 0; i < count; ++i) {
    const double aside_m = step_m * (i - (count - 1) / 2.0);
    row.push_back({i + 1, facing_ball(outlook, {x_m, middle_m + aside_m})});
  }
  man_posts(book, cast, row);
}

// Those ahead first, since they are to be there when the ball is won.
void block(Playbook& book, Cast& cast) {
  const Style& style = book.outlook.style();
  const bool attacks = book.outlook.is_ours();
  const int left = cast.free_robots();
  const int wanted = static_cast<int>(std::lround(attacks ? style.receivers : style.forwards));
  const int share =
      left / static_cast<int>(std::lround(style.robots_per_forward)) + (attacks ? 1 : 0);
  const int ahead = std::clamp(std::min(wanted, share), 0, left);
  send_ahead(book, cast, ahead);
  defend(book, cast, static_cast<int>(std::lround(style.wall)), 0);
  hold_row(book, cast);
}

void counter_play(Playbook& book, Cast& cast) {
  give_goal_and_ball(book, cast);
  block(book, cast);
}

void await_counter(Playbook& book, Cast& cast) {
  give_goal_and_restart(book, cast);
  block(book, cast);
}

}  // namespace

Plan counter_plan() {
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
