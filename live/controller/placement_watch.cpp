#include "live/controller/placement_watch.hpp"

#include <algorithm>

#include "live/controller/stopped_ball.hpp"
#include "live/live_options.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::live {
namespace {

constexpr double kPrecision_m = 0.15;     // 2026, Ball Placement
constexpr double kFromPlacer_m = 0.05_m;  // 2026, Ball Placement: for a free kick of its own
constexpr double kAtRest_s = 0.5_s;       // AutoRef's choice

bool has_left(const TrackedRobots& robots, const Vec2& ball_m) {
  return std::none_of(robots.begin(), robots.end(), [&](const TrackedRobot& robot) {
    return (robot.position_m - ball_m).norm() < kRobotRadius_m + kFromPlacer_m;
  });
}

}  // namespace

std::optional<GameEvent> PlacementWatch::update(const RefereeSignal& signal, const Tracks& tracks) {
  if (signal.command.kind != CommandKind::kBallPlacement) {
    command_counter_.reset();
    return std::nullopt;
  }
  if (command_counter_ != signal.command_counter) begin(signal, tracks);
  if (is_reported_ || !is_placed(signal, tracks)) return std::nullopt;
  is_reported_ = true;
  GameEvent event;
  event.type = GameEventType::kPlacementSucceeded;
  event.origin = {kIdentifier};
  event.by_team = signal.command.side;
  event.time_taken_s = tracks.time_s - begun_s_;
  event.precision_m = (tracks.ball->position_m - signal.placement->target_m).norm();
  event.distance_m = begun_m_ ? (*begun_m_ - signal.placement->target_m).norm() : 0;
  return event;
}

void PlacementWatch::begin(const RefereeSignal& signal, const Tracks& tracks) {
  command_counter_ = signal.command_counter;
  is_reported_ = false;
  begun_s_ = tracks.time_s;
  begun_m_.reset();
  if (tracks.ball) begun_m_ = tracks.ball->position_m;
  at_rest_since_s_.reset();
}

bool PlacementWatch::is_placed(const RefereeSignal& signal, const Tracks& tracks) {
  const bool rests = tracks.ball && signal.placement &&
                     (tracks.ball->position_m - signal.placement->target_m).norm() < kPrecision_m &&
                     tracks.ball->velocity_mps.norm() < kBallAtRest_mps &&
                     has_left(tracks.robots[signal.command.side], tracks.ball->position_m);
  if (!rests) at_rest_since_s_.reset();
  if (rests && !at_rest_since_s_) at_rest_since_s_ = tracks.time_s;
  return rests && tracks.time_s - *at_rest_since_s_ >= kAtRest_s;
}

}  // namespace autoref::live
