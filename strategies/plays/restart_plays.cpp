#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "soccer/robot_shape.hpp"
#include "strategies/plays/plays.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/tactics/defend.hpp"
#include "strategies/tactics/penalty.hpp"

namespace autoref::strategies {
namespace {

constexpr double kPassedOver_m = 10;

// Positions before a kick-off, as fractions of half the field's length and width, in order of
// priority.
constexpr std::array<std::array<double, 2>, kMaxRobots - 1> kKickoffPositions = {{{0.30, 0.0},
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

void give_keeper(const PredictedState& predicted, RoleAssignment& assignment) {
  if (predicted.robots() > 1) assignment.give(0, Role::kKeeper);
}

// The taker: the nearest robot to the ball, except the keeper. Robots that are stuck or behind a
// goal are avoided. The previous taker gets a bonus, so that the role does not alternate between
// two robots.
int choose_taker(const PlayContext& book) {
  const PredictedState& predicted = book.predicted;
  int taker = -1;
  double best_m = std::numeric_limits<double>::infinity();
  for (int i = predicted.robots() > 1 ? 1 : 0; i < predicted.robots(); ++i) {
    const TrackedRobot& robot = predicted.robot(i);
    double distance_m = (robot.position_m - predicted.position_m()).norm();
    if (robot.number == book.former) distance_m -= predicted.style().taker_loyalty_m;
    if (robot.number == book.stuck) distance_m += kPassedOver_m;
    if (std::abs(robot.position_m.x()) > predicted.field().half_length_m() &&
        std::abs(robot.position_m.y()) < predicted.field().half_goal_m() + 2 * kRobotRadius_m)
      distance_m += kPassedOver_m;
    if (distance_m >= best_m) continue;
    best_m = distance_m;
    taker = i;
  }
  return taker;
}

// The taker's position: behind the ball, as seen from the kick's target.
Waypoint taker_position(const PredictedState& predicted, const Vec2& target_m) {
  const Vec2 aim = direction_of(target_m - predicted.position_m(), Vec2(1, 0));
  return {predicted.position_m() - aim * predicted.style().taker_back_m, aim};
}

Vec2 default_target_m(const PredictedState& predicted) {
  return predicted.field().goal_centre_m(Side::kEast) - Vec2(predicted.style().before_goal_m, 0);
}

// The position of the receiver that has the best pass.
Vec2 best_target_m(const PredictedState& predicted, const RoleAssignment& assignment) {
  Vec2 best_m = default_target_m(predicted);
  double best = 0;
  for (int i = 0; i < predicted.robots(); ++i) {
    if (assignment.task(i).role != Role::kReceiver) continue;
    const Vec2& position_m = assignment.task(i).waypoint.position_m;
    const double chance = chance_at(predicted, position_m, predicted.robot(i).number);
    const double worth = worth_of(predicted, chance, position_m, predicted.position_m()) *
                         pass_safety(predicted.position_m(), position_m,
                                     predicted.style().restart_pass_mps, predicted.now().opponents);
    if (worth <= best) continue;
    best = worth;
    best_m = position_m;
  }
  return best_m;
}

}  // namespace

void line_up_taker(const PlayContext& book, RoleAssignment& assignment) {
  for (int i = 0; i < book.predicted.robots(); ++i) {
    if (assignment.task(i).role == Role::kTaker)
      assignment.give(i, Role::kTaker,
                      taker_position(book.predicted, best_target_m(book.predicted, assignment)));
  }
}

void await_kickoff(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  const Field& field = predicted.field();
  give_keeper(predicted, assignment);
  if (predicted.restart_is_ours()) {
    const double back_m = predicted.now().play == Play::kStop
                              ? predicted.style().taker_back_m
                              : kRobotRadius_m + kBallRadius_m + 60_mm;
    assignment.send_nearest({Vec2(-back_m, 0), Vec2(1, 0)});
  }
  for (const auto& share : kKickoffPositions) {
    const Vec2 position_m(-share[0] * field.half_length_m(), share[1] * field.half_width_m());
    if (share[0] == 0.30 && predicted.restart_is_ours()) continue;
    assignment.send_nearest(facing_ball(predicted, position_m));
  }
}

void give_goal_and_restart(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  const Vec2& ball_m = predicted.position_m();
  give_keeper(predicted, assignment);
  if (predicted.restart_is_ours()) {
    const Waypoint waypoint = taker_position(predicted, default_target_m(predicted));
    assignment.give(assignment.nearest_free(waypoint.position_m), Role::kTaker, waypoint);
  } else if (predicted.has_no_room_behind_kick()) {
    assignment.send_nearest(split_wall_position(predicted, 0));
  } else {
    const Vec2 goal_m = predicted.field().goal_centre_m(Side::kWest);
    const Vec2 back = direction_of(goal_m - ball_m, Vec2(-1, 0));
    assignment.send_nearest(facing_ball(predicted, ball_m + back * predicted.style().block_m));
  }
}

void await_restart(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  give_goal_and_restart(book, assignment);
  const int left = assignment.free_robots();
  if (predicted.restart_is_ours()) {
    defend(book, assignment,
           std::clamp(left - 2, 0, static_cast<int>(std::lround(predicted.style().own_wall))), 0);
  } else {
    const bool is_danger = predicted.position_m().x() < predicted.style().upfield_m;
    const int wall = std::min(left, is_danger ? 2 : 1);
    if (predicted.has_no_room_behind_kick()) {
      for (int i = 1; i <= wall; ++i) assignment.send_nearest(split_wall_position(predicted, i));
      defend(book, assignment, 0, left - wall);
    } else {
      defend(book, assignment, wall, left - wall);
    }
  }
  run_for_passes(book, assignment);
}

void take_restart(PlayContext& book, RoleAssignment& assignment) {
  const int taker = choose_taker(book);
  if (taker < 0) return;
  const int number = book.predicted.robot(taker).number;
  if (number != book.former) book.taker_from_s = book.waited_s;
  if (book.waited_s - book.taker_from_s > book.predicted.style().taker_patience_s)
    book.stuck = number;
  assignment.give(taker, Role::kBall);
}

// Until the ball is in play, only the kicker and the keeper matter; the other robots wait behind
// the ball.
void penalty(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  const Vec2& mark_m = predicted.position_m();
  const bool is_attacking = predicted.now().ours;
  const int kicker = is_attacking ? penalty_kicker(predicted.now(), mark_m) : -1;
  if (kicker >= 0 && predicted.now().play == Play::kPenalty) {
    assignment.give(kicker, Role::kBall);
  } else {
    assignment.give(kicker, Role::kStands, penalty_run_up(mark_m));
  }
  for (int i = 0; i < predicted.robots(); ++i) {
    if (!assignment.is_free(i)) continue;
    if (i == 0 && !is_attacking && predicted.style().penalty_on_line) {
      assignment.give(i, Role::kGoalLine, penalty_keeper(predicted.field(), mark_m));
      continue;
    }
    const Waypoint waypoint =
        i == 0 ? penalty_keeper(predicted.field(), mark_m)
               : penalty_spectator(predicted.field(), mark_m, predicted.rules().penalty_clearance_m,
                                   is_attacking, i - 1);
    assignment.give(i, Role::kStands, waypoint);
  }
}

}  // namespace autoref::strategies
