#include "referee/machine/penalty_outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "referee/finding.hpp"
#include "referee/geometry/ball_out.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// The ball's ways before and after a touch are told from this length on: noise of a few
// millimetres turns it by a few degrees only.
constexpr double kWay_m = 100_mm;

bool is_by_keeper(const BallTouch& touch, Side side, const Moment& moment) {
  return touch.robot == RobotId{side, moment.requests[side].keeper};
}

// The angle in degrees by which the newest touch has turned the ball's way, if that is the keeper's
// and both ways are long enough to tell.
std::optional<double> turn_by_keeper_deg(const Memory& memory, const Moment& moment) {
  const PlayMemory& play = memory.play;
  const BallTouch* touch = play.touches.newest();
  const Side defender = opponent_of(*play.kicker);
  if (touch == nullptr || !moment.ball || !is_by_keeper(*touch, defender, moment))
    return std::nullopt;
  const Vec2 from_m = play.touches.has(1) ? play.touches.at(1).began_m : play.place_m;
  const Vec2 before = touch->began_m - from_m;
  const Vec2 after = moment.ball->position_m - touch->began_m;
  if (before.norm() < kWay_m || after.norm() < kWay_m) return std::nullopt;
  return std::abs(angle_between(before, after)) * 180 / std::numbers::pi;
}

PenaltyFailure turned(double turn_deg, const RuleBook& rules) {
  return {turn_deg, rules.penalty_turn_deg, "deg",
          fmt::format("The keeper has turned the ball's way by {:.0f} degrees.", turn_deg)};
}

PenaltyFailure gone_out(const Field& field, const Vec2& ball_m) {
  const double beyond_m = std::max(std::abs(ball_m.x()) - field.half_length_m(),
                                   std::abs(ball_m.y()) - field.half_width_m());
  return {beyond_m, kBallRadius_m, "m",
          fmt::format("The ball left the field at ({:.3f}, {:.3f}) m.", ball_m.x(), ball_m.y())};
}

}  // namespace

bool is_penalty_goal(const Memory& memory, const Moment& moment) {
  if (!moment.ball) return false;
  const Vec2& ball_m = moment.ball->position_m;
  const double goal_end = goal_sign(opponent_of(*memory.play.kicker));
  return ball_m.x() * goal_end > 0 &&
         is_in_goal(moment.configuration.field, ball_m, moment.ball->height_m);
}

std::optional<PenaltyFailure> penalty_failure(const Memory& memory, const Moment& moment) {
  if (is_penalty_goal(memory, moment)) return std::nullopt;
  const Configuration& c = moment.configuration;
  if (moment.ball && is_out_of_field(c.field, moment.ball->position_m)) {
    return gone_out(c.field, moment.ball->position_m);
  }
  const std::optional<double> turn_deg = turn_by_keeper_deg(memory, moment);
  if (turn_deg && *turn_deg >= c.rules.penalty_turn_deg) return turned(*turn_deg, c.rules);
  const double lasted_s = moment.time_s() - memory.play.began_s;
  if (!has_passed(memory.play.began_s, c.rules.penalty_time_s, moment.time_s())) {
    return std::nullopt;
  }
  return PenaltyFailure{lasted_s, c.rules.penalty_time_s, "s",
                        fmt::format("{:.2f} s after the signal there is no goal.", lasted_s)};
}

}  // namespace autoref::referee
