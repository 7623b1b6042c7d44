#include "strategies/teams/chaser.hpp"

#include <algorithm>
#include <array>

#include "strategies/skills/limits.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/skills/play_ball.hpp"
#include "strategies/skills/prediction.hpp"
#include "strategies/tactics/penalty.hpp"

namespace autoref::strategies {
namespace {

constexpr double kShot_mps = 6.0;
constexpr double kOwnHalf_mps =
    2.5;  // speed of kicks from the team's own half, so that they stay in the field
constexpr double kChaserOnLine_m =
    kRobotRadius_m + 30_mm;  // distance of the keeper from its goal line
// The team does not play a ball closer than this to the opponents' area.
constexpr double kFromTheirArea_m = 100_mm;
constexpr double kSlowBall_mps =
    1.2;  // a ball faster than this in the team's own area is a shot: the keeper waits
constexpr double kShotAtUs_mps = 0.3;  // minimum speed of a shot towards the team's own goal line
constexpr double kCaution = 0.93;      // fraction of the kick speed limit that kicks use
constexpr double kChaserClearance_m = 2 * kRobotRadius_m + 20_mm;
constexpr double kStopSpeedShare = 0.8;  // fraction of the speed limit while play is stopped

// Rows of field players, as fractions of half the field's length and width: all in the team's own
// half.
constexpr double kFirstRow = -0.22;
constexpr double kRowStep = -0.12;
constexpr std::array<double, 3> kInRow = {0.0, 0.55, -0.55};

}  // namespace

void Chaser::decide(const TeamView& view, TeamCommands& commands) {
  look_ahead(view, now_);
  if (view.play == Play::kHalt || now_.own.empty()) return;
  requests_.keeper = now_.own.front().number;
  ball_target_m_ = now_.placement_m.value_or(now_.ball.position_m);
  const int chaser = may_chase() ? nearest_to_ball() : -1;
  taker_.update(now_, chaser < 0 ? -1 : now_.own[chaser].number);
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    const auto number = static_cast<std::size_t>(now_.own[i].number);
    commands[number] = i == chaser ? chase(i) : stand(i);
    if (context_.rules.has(RuleId::kBotCrashUnique))
      ease_off(now_.own[i], now_.opponents, {}, commands[number]);
  }
}

// The team does not play a ball in the opponents' area if a rule forbids this.
bool Chaser::may_chase() const {
  if (now_.play != Play::kRunning) return now_.ours && is_restart(now_.play);
  return !context_.rules.has(RuleId::kAttackerTouchedBallInDefenseArea) ||
         distance_to_defence_area(context_.field, Side::kEast, now_.ball.position_m) >
             kFromTheirArea_m;
}

// Returns the index of the keeper if the ball is in the team's own area, otherwise that of a field
// player, or -1 if no robot may play the ball.
int Chaser::nearest_to_ball() const {
  const Vec2& ball_m = now_.ball.position_m;
  const int count = static_cast<int>(now_.own.size());
  const bool is_keepers =
      distance_to_defence_area(context_.field, Side::kWest, ball_m) < kFrontDistance_m;
  if (count > 1 && is_keepers) return now_.ball.velocity_mps.norm() < kSlowBall_mps ? 0 : -1;
  int nearest = -1;
  for (int i = count > 1 ? 1 : 0; i < count; ++i) {
    const auto distance_m = [&](int k) { return (now_.own[k].position_m - ball_m).norm(); };
    if (now_.play == Play::kRunning && now_.own[i].number == taker_.number()) continue;
    if (nearest < 0 || distance_m(i) < distance_m(nearest)) nearest = i;
  }
  return nearest;
}

RobotCommand Chaser::chase(int index) const {
  const TrackedRobot& robot = now_.own[index];
  const Vec2 interception_m = intercept(robot, now_.ball).point_m;
  const double limit_mps = kCaution * context_.rules.kick_limit_mps;
  Intent intent;
  intent.target_m = best_shot(context_.field, interception_m, now_.opponents).target_m;
  intent.kick_mps = interception_m.x() < 0 ? kOwnHalf_mps : std::min(kShot_mps, limit_mps);
  return play_ball(robot, now_.ball, interception_m, intent, obstacles_for(index, false), {});
}

RobotCommand Chaser::stand(int index) const {
  const TrackedRobot& robot = now_.own[index];
  const bool is_keeper = index == 0 && now_.own.size() > 1;
  Waypoint waypoint = waypoint_of(index);
  if (const auto path_m = exit_from_behind_goal(context_.field, robot.position_m))
    waypoint.position_m = *path_m;
  DrivingStyle style;
  if (now_.play == Play::kStop && context_.rules.has(RuleId::kBotTooFastInStop))
    style.speed_mps = kStopSpeedShare * context_.rules.stop_speed_mps;
  return drive_to(robot, waypoint, is_keeper ? Obstacles{} : obstacles_for(index, true), style);
}

// The waypoint depends only on the ball's position, so all robots come to rest in a stop.
Waypoint Chaser::waypoint_of(int index) const {
  const Field& field = context_.field;
  if (now_.play == Play::kPreparePenalty || now_.play == Play::kPenalty) {
    if (now_.ours && index == penalty_kicker(now_, ball_target_m_))
      return penalty_run_up(ball_target_m_);
    if (index == 0) return penalty_keeper(field, ball_target_m_);
    return penalty_spectator(field, ball_target_m_, context_.rules.penalty_clearance_m, now_.ours,
                             index - 1);
  }
  Vec2 position_m(-field.half_length_m() + kChaserOnLine_m, 0);
  if (index == 0 && now_.own.size() > 1) {
    position_m.y() = keeper_y_m(position_m.x());
  } else {
    const int command = std::max(index - 1, 0);
    const auto in_row = static_cast<std::size_t>(command) % kInRow.size();
    const int row = command / static_cast<int>(kInRow.size());
    const Vec2 wanted_m((kFirstRow + kRowStep * row) * field.half_length_m(),
                        kInRow[in_row] * field.half_width_m());
    position_m = permitted(field, wanted_m, ball_target_m_, limits());
  }
  return {position_m, direction_of(ball_target_m_ - position_m, Vec2(1, 0))};
}

// Where a shot will cross the keeper's line; if there is no shot, a position shifted towards the
// ball.
double Chaser::keeper_y_m(double line_x_m) const {
  const Vec2& velocity_mps = now_.ball.velocity_mps;
  const double reach_m = context_.field.half_goal_m() - kRobotRadius_m / 2;
  const Vec2 from_line_m = ball_target_m_ - Vec2(line_x_m, 0);
  if (velocity_mps.x() > -kShotAtUs_mps) return reach_m * direction_of(from_line_m, Vec2(1, 0)).y();
  const double y_m = from_line_m.y() - velocity_mps.y() * from_line_m.x() / velocity_mps.x();
  return std::clamp(y_m, -reach_m, reach_m);
}

Limits Chaser::limits() const {
  Limits limits;
  if (now_.play == Play::kRunning || (now_.ours && is_restart(now_.play))) return limits;
  limits.keep_from_ball_m = kRobotRadius_m + kBallRadius_m + context_.rules.opponents_to_ball_m;
  return limits;
}

Obstacles Chaser::obstacles_for(int index, bool keeps_off_ball) const {
  Obstacles obstacles;
  obstacles.farthest_m = farthest_between_walls_m(context_.field);
  for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
    if (i != index) obstacles.push_back({now_.own[i].position_m, kChaserClearance_m});
  }
  for (const TrackedRobot& opponent : now_.opponents)
    obstacles.push_back({opponent.position_m, kChaserClearance_m});
  if (keeps_off_ball)
    obstacles.push_back(
        {now_.ball.position_m, std::max(limits().keep_from_ball_m, kChaserClearance_m)});
  return obstacles;
}

}  // namespace autoref::strategies
