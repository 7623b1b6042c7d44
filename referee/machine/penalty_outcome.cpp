#include "referee/machine/penalty_outcome.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "referee/finding.hpp"
#include "referee/geometry/ball_out.hpp"
#include "referee/machine/ball_in_play.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// Minimum length of the ball's path before and after a touch that is needed to measure the path's
// direction. Over this length, noise of a few millimetres changes the direction by only a few
// degrees.
constexpr double kShortest_m = 100_mm;
// Because of vision noise, a ball slower than this does not count as moving.
constexpr double kMoves_mps = 0.2_mps;
// The distance that a ball has moved back must exceed the tolerance by this many standard
// deviations of both positions.
constexpr double kSurelyBack = 3;

bool is_by_keeper(const BallTouch& touch, Side side, const RefereeInput& input) {
  return touch.robot == RobotId{side, input.requests[side].keeper};
}

// The angle in degrees by which the newest touch turned the ball's path. Returns nullopt if the
// toucher is not the keeper, or if the path is too short to measure.
std::optional<double> turn_by_keeper_deg(const RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  const BallTouch* touch = play.touches.newest();
  const Side defender = opponent_of(*play.kicker);
  if (touch == nullptr || !input.ball || !is_by_keeper(*touch, defender, input))
    return std::nullopt;
  const Vec2 from_m = play.touches.has(1) ? play.touches.at(1).began_m : play.position_m;
  const Vec2 before = touch->began_m - from_m;
  const Vec2 after = input.ball->position_m - touch->began_m;
  if (before.norm() < kShortest_m || after.norm() < kShortest_m) return std::nullopt;
  return std::abs(angle_between(before, after)) * 180 / std::numbers::pi;
}

PenaltyFailure turned(double turn_deg, const RuleBook& rules) {
  return {turn_deg, rules.penalty_turn_deg, "deg",
          fmt::format("The keeper turned the ball's path by {:.0f} degrees.", turn_deg)};
}

PenaltyFailure without_measure(const char* evidence) { return {0, 0, "", evidence}; }

// In a shoot-out, a kick is over once any defender has turned the ball back.
bool is_saved(const RefereeState& state, const RefereeInput& input) {
  const Side defender = opponent_of(*state.play.kicker);
  return input.last_touch.side == defender && input.tracks.ball &&
         goal_sign(defender) * input.tracks.ball->velocity_mps.x() < -kMoves_mps;
}

// Whether a robot other than the keeper has played the ball after the kick.
bool is_played_again(const RefereeState& state, const RefereeInput& input) {
  const TouchHistory& touches = state.play.touches;
  const Side defender = opponent_of(*state.play.kicker);
  return touches.count() > 1 && touches.newest()->robot &&
         is_settled(*touches.newest(), input.time_s()) &&
         !is_by_keeper(*touches.newest(), defender, input);
}

// "The ball has to only move towards the opponent goal" (2026). The ball may come back by the
// distance that it has to move to be in play. It may also come back off a defender; in that case,
// the angle decides.
std::optional<PenaltyFailure> moved_back(const RefereeState& state, const RefereeInput& input) {
  if (!input.ball || input.last_touch.side == opponent_of(*state.play.kicker)) return std::nullopt;
  const double back_m = state.play.farthest_m - goalwards_m(state.play, input);
  const double limit_m = input.configuration.rules.in_play_m +
                         kSurelyBack * std::sqrt(2.0) * input.configuration.noise.ball_m;
  if (!(back_m > limit_m)) return std::nullopt;
  return PenaltyFailure{back_m, limit_m, "m",
                        fmt::format("The ball has moved back by {:.0f} mm.", 1e3 * back_m)};
}

// Reasons for failure that only exist under some rule books or in a shoot-out.
std::optional<PenaltyFailure> special_failure(const RefereeState& state,
                                              const RefereeInput& input) {
  const bool is_2026 = input.configuration.rules.edition == Edition::kRules2026;
  if (is_2026) {
    if (std::optional<PenaltyFailure> back = moved_back(state, input)) return back;
  }
  if (state.signal.stage != Stage::kShootout) return std::nullopt;
  if (is_saved(state, input)) return without_measure("The kick was saved.");
  if (!is_2026 && is_played_again(state, input))
    return without_measure("The ball was played again after the kick.");
  return std::nullopt;
}

PenaltyFailure gone_out(const Field& field, const Vec2& ball_m) {
  const double beyond_m = std::max(std::abs(ball_m.x()) - field.half_length_m(),
                                   std::abs(ball_m.y()) - field.half_width_m());
  return {beyond_m, kBallRadius_m, "m", "The ball left the field."};
}

}  // namespace

Side next_kicker(const ShootoutBook& book, const Configuration& configuration) {
  const Side first = configuration.first_kickoff;
  const bool is_level = book.kicks[first] == book.kicks[opponent_of(first)];
  return is_level ? first : opponent_of(first);
}

bool is_decided(const ShootoutBook& book, int kicks) {
  // A shoot-out is decided once a side leads by more goals than the other can still score. After
  // the regular kicks (sudden death), the only remaining kick is the one that makes the numbers of
  // kicks equal.
  const int most = std::max({kicks, book.kicks[Side::kWest], book.kicks[Side::kEast]});
  return std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
    const Side other = opponent_of(side);
    return book.goals[side] > book.goals[other] + most - book.kicks[other];
  });
}

bool is_over(const ShootoutBook& book, int kicks) {
  const int least = std::min(book.kicks[Side::kWest], book.kicks[Side::kEast]);
  return is_decided(book, kicks) || least >= kMostShootoutKicks;
}

bool is_penalty_goal(const RefereeState& state, const RefereeInput& input) {
  if (!input.ball) return false;
  const Vec2& ball_m = input.ball->position_m;
  const double goal_end = goal_sign(opponent_of(*state.play.kicker));
  return ball_m.x() * goal_end > 0 &&
         is_in_goal(input.configuration.field, ball_m, input.ball->height_m);
}

std::optional<PenaltyFailure> penalty_failure(const RefereeState& state,
                                              const RefereeInput& input) {
  const Configuration& c = input.configuration;
  if (state.play.is_decided_by_foul_of(*state.play.kicker))
    return without_measure("The kicker's side committed a foul.");
  if (is_penalty_goal(state, input)) return std::nullopt;
  if (input.ball && is_out_of_field(c.field, input.ball->position_m)) {
    return gone_out(c.field, input.ball->position_m);
  }
  const std::optional<double> turn_deg = turn_by_keeper_deg(state, input);
  if (turn_deg && *turn_deg >= c.rules.penalty_turn_deg) return turned(*turn_deg, c.rules);
  if (std::optional<PenaltyFailure> special = special_failure(state, input)) return special;
  const double lasted_s = input.time_s() - state.play.began_s;
  if (!has_passed(state.play.began_s, c.rules.penalty_time_s, input.time_s())) {
    return std::nullopt;
  }
  return PenaltyFailure{lasted_s, c.rules.penalty_time_s, "s",
                        fmt::format("There was no goal within {:.2f} s of the signal.", lasted_s)};
}

bool is_goal_awarded(const RefereeState& state, const RefereeInput& input) {
  return input.configuration.rules.penalty_fouls_decide &&
         state.play.is_decided_by_foul_of(opponent_of(*state.play.kicker));
}

bool is_penalty_over(const RefereeState& state, const RefereeInput& input) {
  if (state.watch.penalty_positions.is_over || is_penalty_goal(state, input)) return true;
  if (penalty_failure(state, input)) return true;
  const bool is_2026 = input.configuration.rules.edition == Edition::kRules2026;
  return !is_2026 && is_played_again(state, input);
}

}  // namespace autoref::referee
