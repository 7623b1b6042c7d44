// Possession. While it has the ball, the others spread around it as a net, each where a short pass
// gets through; without it, it defends like cobalt.
#include <algorithm>

#include "soccer/trigonometry.hpp"
#include "strategies/plays/posts.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/teams/plans.hpp"

namespace autoref::strategies {
namespace {

Vec2 on_field(const Outlook& outlook, const Vec2& p) {
  const double from_edge_m = outlook.style().net_from_edge_m;
  const double x_m = outlook.field().half_length_m() - from_edge_m;
  const double y_m = outlook.field().half_width_m() - from_edge_m;
  return {std::clamp(p.x(), -x_m, x_m), std::clamp(p.y(), -y_m, y_m)};
}

// Where a pass from the ball gets through best, about in that direction.
Waypoint knot(const Outlook& outlook, const Vec2& way) {
  const Vec2& ball_m = outlook.place_m();
  const double net_m = outlook.style().net_m;
  Waypoint best;
  double best_score = -1e9;
  for (const double aside : {0.0, 1.0, -1.0}) {
    const Vec2 bent = to_world(heading_of(aside * outlook.style().net_aside_rad), way);
    for (const double reach : {1.0, outlook.style().net_nearest}) {
      const Vec2 wanted_m = on_field(outlook, ball_m + bent * (reach * net_m));
      const Waypoint place = off_their_area(outlook, wanted_m);
      const double near =
          1 - (place.position_m - ball_m).norm() / (outlook.style().net_nearest * net_m);
      const double score = pass_safety(ball_m, place.position_m, outlook.style().net_pass_mps,
                                       outlook.now().opponents) +
                           (aside == 0 && reach == 1 ? outlook.style().net_plain : 0) -
                           outlook.style().net_too_near * std::max(0.0, near);
      if (score <= best_score) continue;
      best_score = score;
      best = place;
    }
  }
  return best;
}

// The net: evenly around the ball, open towards the own goal, where the back stands.
void spread_net(Playbook& book, Cast& cast) {
  const Outlook& outlook = book.outlook;
  const int count = cast.free_robots();
  const Vec2 goal_m = outlook.field().goal_centre_m(Side::kEast);
  const Vec2 ahead = direction_of(goal_m - outlook.place_m(), Vec2(1, 0));
  const double step_rad = std::min(outlook.style().net_widest_rad, 2 * kPi / std::max(count, 1));
  Posts knots;
  for (int i = 0; i < count; ++i) {
    const double turn_rad = step_rad * (i - (count - 1) / 2.0);
    knots.push_back({i + 1, knot(outlook, to_world(heading_of(turn_rad), ahead))});
  }
  man_posts(book, cast, knots);
}

void possession_play(Playbook& book, Cast& cast) {
  if (!book.outlook.is_ours()) return open_play(book, cast);
  give_goal_and_ball(book, cast);
  defend(book, cast, cast.free_robots() > 2 ? 1 : 0, 0);
  spread_net(book, cast);
}

void await_possession(Playbook& book, Cast& cast) {
  if (!book.outlook.restart_is_ours()) return await_restart(book, cast);
  give_goal_and_restart(book, cast);
  defend(book, cast, cast.free_robots() > 2 ? 1 : 0, 0);
  spread_net(book, cast);
}

}  // namespace

Plan possession_plan() {
  Style style;
  style.shot_threshold = 0.2;
  style.pass_arrival_mps = 1.4;
  style.pass_risk = 0.1;
  style.patience = 0.15;
  style.carry = 0.4;
  return {style, possession_play, await_possession};
}

}  // namespace autoref::strategies
