#include <algorithm>
#include <cmath>
#include <limits>

#include "strategies/plays/plays.hpp"
#include "strategies/tactics/defend.hpp"
#include "strategies/tactics/keeper.hpp"

namespace autoref::strategies {
namespace {

int count_of(double wanted) { return static_cast<int>(std::lround(wanted)); }

// The lowest number keeps the goal, unless it is alone and its team gets the ball first.
void give_goal(const Outlook& outlook, Cast& cast) {
  if (outlook.robots() == 0) return;
  if (outlook.robots() == 1 && outlook.is_ours()) return;
  cast.give(0, is_keepers_ball(outlook) ? Part::kBall : Part::kKeeper);
}

// Whether the opponents could have the ball the next moment.
bool is_contested(const Outlook& outlook) {
  return outlook.theirs().time_s < outlook.style().contested_s;
}

}  // namespace

int choose_for_ball(const Playbook& book, const Cast& cast) {
  const Outlook& outlook = book.outlook;
  int best = -1;
  double best_s = std::numeric_limits<double>::infinity();
  for (int i = 0; i < outlook.robots(); ++i) {
    if (!cast.is_free(i)) continue;
    const int number = outlook.robot(i).number;
    double time_s = outlook.meeting(i).time_s;
    if (number == book.former) time_s -= outlook.style().ball_loyalty_s;
    if (number == book.handler.receiver()) time_s -= outlook.style().receiver_bonus_s;
    if (number == book.restarter) time_s += outlook.style().next_touch_s;
    if (!outlook.may_touch_at(outlook.meeting(i).point_m)) time_s += outlook.style().forbidden_s;
    if (time_s >= best_s) continue;
    best_s = time_s;
    best = i;
  }
  return best;
}

namespace {

// The ball's part, or where the rules forbid to touch the ball, a place as near as may be.
void give_ball(Playbook& book, Cast& cast) {
  const Outlook& outlook = book.outlook;
  const int chosen = choose_for_ball(book, cast);
  if (chosen < 0) return;
  const Vec2& ball_m = outlook.path().now_m();
  const bool is_restarter = outlook.robot(chosen).number == book.restarter;
  if (outlook.may_touch_at(ball_m) && outlook.may_touch_at(outlook.meeting(chosen).point_m) &&
      !is_restarter) {
    cast.give(chosen, Part::kBall);
    return;
  }
  const Vec2 goal_m = outlook.field().goal_centre_m(Side::kWest);
  const Vec2 back = direction_of(goal_m - ball_m, Vec2(-1, 0));
  cast.give(chosen, Part::kStands,
            facing_ball(outlook, ball_m + back * outlook.style().beside_ball_m));
}

}  // namespace

void defend(Playbook& book, Cast& cast, int wall, int markers) {
  const Outlook& outlook = book.outlook;
  const int count = std::min(wall, cast.free_robots());
  for (int i = 0; i < count; ++i) cast.send_nearest(wall_place(outlook, i, count));
  for (const int opponent : dangerous_opponents(outlook)) {
    if (markers-- <= 0) break;
    cast.send_nearest(mark_place(outlook, opponent));
  }
}

void cover(const Playbook& book, Cast& cast, int count) {
  const Vec2& ball_m = book.outlook.place_m();
  const Vec2 goal_m = book.outlook.field().goal_centre_m(Side::kWest);
  for (int i = 1; i <= count; ++i) {
    const double share =
        std::min(0.5, book.outlook.style().cover_m * i /
                          std::max((goal_m - ball_m).norm(), book.outlook.style().cover_m));
    cast.send_nearest(facing_ball(book.outlook, ball_m + share * (goal_m - ball_m)));
  }
}

void run_for_passes(Playbook& book, Cast& cast) {
  boost::container::static_vector<int, kMaxRobots> receivers;
  for (int i = 0; i < book.outlook.robots(); ++i) {
    if (cast.is_free(i)) receivers.push_back(i);
  }
  book.field.send(receivers);
  for (const int i : receivers) {
    const Vec2& place_m = book.field.place_of(book.outlook.robot(i).number);
    cast.give(i, Part::kReceiver, facing_ball(book.outlook, place_m));
  }
}

void give_goal_and_ball(Playbook& book, Cast& cast) {
  give_goal(book.outlook, cast);
  const bool keeper_has_it = book.outlook.robots() > 0 && cast.task(0).part == Part::kBall;
  if (!keeper_has_it) give_ball(book, cast);
}

void open_play(Playbook& book, Cast& cast) {
  const Outlook& outlook = book.outlook;
  const Style& style = outlook.style();
  give_goal_and_ball(book, cast);
  const int left = cast.free_robots();
  if (outlook.is_ours()) {
    const int backs = outlook.path().now_m().x() < 0 || is_contested(outlook) ? 2 : 1;
    const int ahead = std::min(count_of(style.receivers), left - backs);
    defend(book, cast, left - std::max(ahead, 0), 0);
  } else {
    const int ahead = std::clamp(left - 2, 0, count_of(style.forwards));
    const int wall = std::min(count_of(style.wall), left - ahead);
    defend(book, cast, wall, std::min(count_of(style.markers), left - ahead - wall));
    cover(book, cast, cast.free_robots() - ahead);
  }
  run_for_passes(book, cast);
}

}  // namespace autoref::strategies
