#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "soccer/robot_shape.hpp"
#include "strategies/plays/plays.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/tactics/defend.hpp"

namespace autoref::strategies {
namespace {

constexpr double kPassedOver_m = 10;

// Before a kick-off, as shares of the half's length and width, in the order in which they are
// filled.
constexpr std::array<std::array<double, 2>, kMaxRobots - 1> kKickoffPlaces = {{{0.30, 0.0},
                                                                               {0.12, 0.55},
                                                                               {0.12, -0.55},
                                                                               {0.55, 0.28},
                                                                               {0.55, -0.28},
                                                                               {0.35, 0.7},
                                                                               {0.35, -0.7},
                                                                               {0.6, 0.0},
                                                                               {0.2, 0.3},
                                                                               {0.2, -0.3},
                                                                               {0.45, 0.45},
                                                                               {0.45, -0.45},
                                                                               {0.7, 0.7},
                                                                               {0.7, -0.7},
                                                                               {0.2, 0.85}}};

void give_keeper(const Outlook& outlook, Cast& cast) {
  if (outlook.robots() > 1) cast.give(0, Part::kKeeper);
}

// The nearest but the keeper; one that is shut in in a goal, or gets nowhere, is passed over.
int choose_taker(const Playbook& book) {
  const Outlook& outlook = book.outlook;
  int taker = -1;
  double best_m = std::numeric_limits<double>::infinity();
  for (int i = outlook.robots() > 1 ? 1 : 0; i < outlook.robots(); ++i) {
    const TrackedRobot& robot = outlook.robot(i);
    double distance_m = (robot.position_m - outlook.place_m()).norm();
    if (robot.number == book.former) distance_m -= outlook.style().taker_loyalty_m;
    if (robot.number == book.stuck) distance_m += kPassedOver_m;
    if (std::abs(robot.position_m.x()) > outlook.field().half_length_m() &&
        std::abs(robot.position_m.y()) < outlook.field().half_goal_m() + 2 * kRobotRadius_m)
      distance_m += kPassedOver_m;
    if (distance_m >= best_m) continue;
    best_m = distance_m;
    taker = i;
  }
  return taker;
}

// Behind the ball, seen from where it is meant to go.
Waypoint taker_place(const Outlook& outlook, const Vec2& target_m) {
  const Vec2 aim = direction_of(target_m - outlook.place_m(), Vec2(1, 0));
  return {outlook.place_m() - aim * outlook.style().taker_back_m, aim};
}

Vec2 default_target_m(const Outlook& outlook) {
  return outlook.field().goal_centre_m(Side::kEast) - Vec2(outlook.style().before_goal_m, 0);
}

// The place of the receiver whom a pass serves best.
Vec2 best_target_m(const Outlook& outlook, const Cast& cast) {
  Vec2 best_m = default_target_m(outlook);
  double best = 0;
  for (int i = 0; i < outlook.robots(); ++i) {
    if (cast.task(i).part != Part::kReceiver) continue;
    const Vec2& place_m = cast.task(i).place.position_m;
    const double chance = chance_at(outlook, place_m, outlook.robot(i).number);
    const double worth = worth_of(outlook, chance, place_m, outlook.place_m()) *
                         pass_safety(outlook.place_m(), place_m, outlook.style().restart_pass_mps,
                                     outlook.now().opponents);
    if (worth <= best) continue;
    best = worth;
    best_m = place_m;
  }
  return best_m;
}

}  // namespace

void line_up_taker(const Playbook& book, Cast& cast) {
  for (int i = 0; i < book.outlook.robots(); ++i) {
    if (cast.task(i).part == Part::kTaker)
      cast.give(i, Part::kTaker, taker_place(book.outlook, best_target_m(book.outlook, cast)));
  }
}

void await_kickoff(Playbook& book, Cast& cast) {
  const Outlook& outlook = book.outlook;
  const Field& field = outlook.field();
  give_keeper(outlook, cast);
  if (outlook.restart_is_ours()) {
    const double back_m = outlook.now().play == Play::kStop
                              ? outlook.style().taker_back_m
                              : kRobotRadius_m + kBallRadius_m + 60_mm;
    cast.send_nearest({Vec2(-back_m, 0), Vec2(1, 0)});
  }
  for (const auto& share : kKickoffPlaces) {
    const Vec2 place_m(-share[0] * field.half_length_m(), share[1] * field.half_width_m());
    if (share[0] == 0.30 && outlook.restart_is_ours()) continue;
    cast.send_nearest(facing_ball(outlook, place_m));
  }
}

void give_goal_and_restart(Playbook& book, Cast& cast) {
  const Outlook& outlook = book.outlook;
  const Vec2& ball_m = outlook.place_m();
  give_keeper(outlook, cast);
  if (outlook.restart_is_ours()) {
    const Waypoint place = taker_place(outlook, default_target_m(outlook));
    cast.give(cast.nearest_free(place.position_m), Part::kTaker, place);
  } else {
    const Vec2 goal_m = outlook.field().goal_centre_m(Side::kWest);
    const Vec2 back = direction_of(goal_m - ball_m, Vec2(-1, 0));
    cast.send_nearest(facing_ball(outlook, ball_m + back * outlook.style().block_m));
  }
}

void await_restart(Playbook& book, Cast& cast) {
  const Outlook& outlook = book.outlook;
  give_goal_and_restart(book, cast);
  const int left = cast.free_robots();
  if (outlook.restart_is_ours()) {
    defend(book, cast,
           std::clamp(left - 2, 0, static_cast<int>(std::lround(outlook.style().own_wall))), 0);
  } else {
    const bool is_danger = outlook.place_m().x() < outlook.style().upfield_m;
    const int wall = std::min(left, is_danger ? 2 : 1);
    defend(book, cast, wall, left - wall);
  }
  run_for_passes(book, cast);
}

void take_restart(Playbook& book, Cast& cast) {
  const int taker = choose_taker(book);
  if (taker < 0) return;
  const int number = book.outlook.robot(taker).number;
  if (number != book.former) book.taker_from_s = book.waited_s;
  if (book.waited_s - book.taker_from_s > book.outlook.style().taker_patience_s)
    book.stuck = number;
  cast.give(taker, Part::kBall);
}

}  // namespace autoref::strategies
