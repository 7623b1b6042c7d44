#include <algorithm>
#include <cmath>
#include <limits>

#include "strategies/plays/plays.hpp"
#include "strategies/skills/strike.hpp"
#include "strategies/tactics/defend.hpp"
#include "strategies/tactics/keeper.hpp"

namespace autoref::strategies {
namespace {

// How much earlier than an opponent the robot must reach the ball.
constexpr double kClearsAlone_s = 0.4;

int count_of(double wanted) { return static_cast<int>(std::lround(wanted)); }

// Whether a robot without team-mates can clear a ball near its goal well before an opponent reaches
// it.
bool can_clear_alone(const PredictedState& predicted) {
  const BallInterception& own = predicted.interception(0);
  return own.point_m.x() < 0 && own.time_s + kClearsAlone_s < predicted.theirs().time_s;
}

// The robot with the lowest number keeps the goal, unless no opponent can shoot at it. Without
// team-mates, it leaves the goal only to clear the ball.
void give_goal(const PredictedState& predicted, RoleAssignment& assignment) {
  if (predicted.robots() == 0) return;
  if (predicted.now().opponents.empty() && !is_keepers_ball(predicted)) return;
  const bool is_keepers =
      is_keepers_ball(predicted) || (predicted.robots() == 1 && can_clear_alone(predicted));
  assignment.give(0, is_keepers ? Role::kBall : Role::kKeeper);
}

// Whether the opponents could soon have the ball.
bool is_contested(const PredictedState& predicted) {
  return predicted.theirs().time_s < predicted.style().contested_s;
}

}  // namespace

int choose_for_ball(const PlayContext& book, const RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  int best = -1;
  double best_s = std::numeric_limits<double>::infinity();
  for (int i = 0; i < predicted.robots(); ++i) {
    if (!assignment.is_free(i)) continue;
    const int number = predicted.robot(i).number;
    double time_s = predicted.interception(i).time_s;
    if (number == book.former) time_s -= predicted.style().ball_loyalty_s;
    if (number == book.handler.receiver()) time_s -= predicted.style().receiver_bonus_s;
    if (has_ball(predicted.robot(i), predicted.path().now_m()))
      time_s -= predicted.style().holder_bonus_s;
    if (number == book.restarter) time_s += predicted.style().next_touch_s;
    if (!predicted.may_touch_at(predicted.interception(i).point_m))
      time_s += predicted.style().forbidden_s;
    if (time_s >= best_s) continue;
    best_s = time_s;
    best = i;
  }
  return best;
}

namespace {

// The style's numbers of robots per role, for `left` free robots. These numbers are meant for teams
// of six; a large team shares out its additional robots.
struct Shares {
  int wall;
  int markers;
  int forwards;
  int receivers;
};
Shares shares_of(const Style& style, int left) {
  Shares shares{count_of(style.wall), count_of(style.markers), count_of(style.forwards),
                count_of(style.receivers)};
  constexpr int kUsual = 4;  // six robots minus the keeper and the robot at the ball
  const int more = style.large_team ? std::max(0, left - kUsual) : 0;
  shares.wall += more / 4;
  shares.markers += (more + 1) / 2;
  shares.forwards += (more + 2) / 5;
  shares.receivers += (more + 1) / 2;
  return shares;
}

// Assigns the ball or, if the rules forbid touching it, a position close to it.
void give_ball(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  const int chosen = choose_for_ball(book, assignment);
  if (chosen < 0) return;
  const Vec2& ball_m = predicted.path().now_m();
  const bool is_restarter = predicted.robot(chosen).number == book.restarter;
  if (predicted.may_touch_at(ball_m) &&
      predicted.may_touch_at(predicted.interception(chosen).point_m) && !is_restarter) {
    assignment.give(chosen, Role::kBall);
    return;
  }
  const Vec2 goal_m = predicted.field().goal_centre_m(Side::kWest);
  const Vec2 back = direction_of(goal_m - ball_m, Vec2(-1, 0));
  assignment.give(chosen, Role::kStands,
                  facing_ball(predicted, ball_m + back * predicted.style().beside_ball_m));
}

}  // namespace

void defend(PlayContext& book, RoleAssignment& assignment, int wall, int markers) {
  const PredictedState& predicted = book.predicted;
  const int count = std::min(wall, assignment.free_robots());
  for (int i = 0; i < count; ++i) assignment.send_nearest(wall_position(predicted, i, count));
  for (const int opponent : dangerous_opponents(predicted)) {
    if (markers-- <= 0) break;
    assignment.send_nearest(mark_position(predicted, opponent));
  }
}

void cover(const PlayContext& book, RoleAssignment& assignment, int count) {
  const Vec2& ball_m = book.predicted.position_m();
  const Vec2 goal_m = book.predicted.field().goal_centre_m(Side::kWest);
  for (int i = 1; i <= count; ++i) {
    const double share =
        std::min(0.5, book.predicted.style().cover_m * i /
                          std::max((goal_m - ball_m).norm(), book.predicted.style().cover_m));
    assignment.send_nearest(facing_ball(book.predicted, ball_m + share * (goal_m - ball_m)));
  }
}

void run_for_passes(PlayContext& book, RoleAssignment& assignment) {
  boost::container::static_vector<int, kMaxRobots> receivers;
  for (int i = 0; i < book.predicted.robots(); ++i) {
    if (assignment.is_free(i)) receivers.push_back(i);
  }
  book.field.send(receivers);
  for (const int i : receivers) {
    const Vec2& position_m = book.field.position_of(book.predicted.robot(i).number);
    assignment.give(i, Role::kReceiver, facing_ball(book.predicted, position_m));
  }
}

void give_goal_and_ball(PlayContext& book, RoleAssignment& assignment) {
  give_goal(book.predicted, assignment);
  const bool keeper_has_it = book.predicted.robots() > 0 && assignment.task(0).role == Role::kBall;
  if (!keeper_has_it) give_ball(book, assignment);
}

void open_play(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  give_goal_and_ball(book, assignment);
  const int left = assignment.free_robots();
  const Shares shares = shares_of(predicted.style(), left);
  // Opponents that may come to shoot: all except one, which is taken for their goalkeeper.
  const int threats = std::max(0, static_cast<int>(predicted.now().opponents.size()) - 1);
  if (predicted.is_ours()) {
    const int backs = predicted.path().now_m().x() < 0 || is_contested(predicted) ? 2 : 1;
    const int ahead = std::min(shares.receivers, left - std::min(backs, threats));
    defend(book, assignment, std::min(left - std::max(ahead, 0), threats), 0);
  } else {
    const int ahead = std::clamp(left - 2, 0, shares.forwards);
    const int wall = std::min({shares.wall, (left - ahead + 1) / 2, threats});
    defend(book, assignment, wall, std::min(shares.markers, left - ahead - wall));
    cover(book, assignment, assignment.free_robots() - ahead);
  }
  run_for_passes(book, assignment);
}

}  // namespace autoref::strategies
