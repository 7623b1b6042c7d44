#include "live/controller/stopped_ball.hpp"

#include <algorithm>
#include <utility>

#include "referee/geometry/restarts.hpp"
#include "referee/machine/ball_placement.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::live {
namespace {

// Tolerance of the distance that robots keep from the ball; AutoRef's choice.
constexpr double kTolerance_m = 0.05_m;

}  // namespace

bool is_in_position(const RefereeSignal& signal, const Tracks& tracks) {
  return tracks.ball && signal.placement &&
         (tracks.ball->position_m - signal.placement->target_m).norm() < kBallInPosition_m;
}

StoppedBall::StoppedBall(const game::GameConfiguration& game, std::vector<GameEvent> events,
                         const RefereeSignal& signal, const Tracks& tracks)
    : game_(&game),
      events_(std::move(events)),
      signal_(&signal),
      next_(signal.next_command.value_or(Command{CommandKind::kForceStart})),
      tracks_(&tracks) {}

bool StoppedBall::was_placed_by(Side side) const {
  return has_event(GameEventType::kPlacementSucceeded, side);
}

bool StoppedBall::is_at_rest() const {
  return tracks_->ball && tracks_->ball->velocity_mps.norm() < kBallAtRest_mps;
}

bool StoppedBall::is_out_of_reach() const {
  return is_at_rest() &&
         referee::is_out_of_reach(game_->field, game_->match.rules, tracks_->ball->position_m);
}

// After a placement, the placing robot may have moved the ball a little.
bool StoppedBall::is_ready() const {
  if (!signal_->placement) return true;
  if (!is_left_to_teams()) return is_in_position(*signal_, *tracks_);
  if (!is_at_rest()) return false;
  const RuleBook& rules = game_->match.rules;
  const Vec2& ball_m = tracks_->ball->position_m;
  const Vec2& target_m = signal_->placement->target_m;
  const bool was_placed = was_placed_by(Side::kWest) || was_placed_by(Side::kEast);
  const double near_m = was_placed ? rules.placement_not_needed_m : rules.placement_tolerance_m;
  return (ball_m - target_m).norm() <= near_m ||
         referee::ball_may_stay(game_->field, rules, ball_m, target_m);
}

std::optional<Side> StoppedBall::placer() const {
  if (!is_left_to_teams()) return std::nullopt;
  const Side kicker = next_.side;
  for (const Side side : {kicker, opponent_of(kicker)}) {
    if (signal_->can_place_ball[side] && !has_event(GameEventType::kPlacementFailed, side))
      return side;
  }
  return std::nullopt;
}

bool StoppedBall::needs_placement_by_hand(double waited_s) const {
  return !placer() || is_out_of_reach() || waited_s >= kLongestStop_s;
}

bool StoppedBall::are_robots_away() const {
  if (!tracks_->ball) return true;
  const double distance_m = game_->match.rules.opponents_to_ball_m + kRobotRadius_m - kTolerance_m;
  const bool is_free_kick = next_.kind == CommandKind::kDirectFree;
  return std::none_of(kSides.begin(), kSides.end(), [&](Side side) {
    if (is_free_kick && side == next_.side) return false;
    const TrackedRobots& robots = tracks_->robots[side];
    return std::any_of(robots.begin(), robots.end(), [&](const TrackedRobot& robot) {
      return (robot.position_m - tracks_->ball->position_m).norm() < distance_m;
    });
  });
}

bool StoppedBall::is_left_to_teams() const {
  return game_->match.placement == referee::PlacedBy::kTeams &&
         referee::is_placed_by_team(next_.kind);
}

bool StoppedBall::has_event(GameEventType type, Side by_team) const {
  return std::any_of(events_.begin(), events_.end(), [&](const GameEvent& event) {
    return event.type == type && event.by_team == by_team;
  });
}

}  // namespace autoref::live
