#include "game/play_counts/duels.hpp"

#include <cmath>

#include "game/play_counts/play_counts.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::game {

Duels::Duels(double frame_rate_hz)
    : begin_frames_(static_cast<int>(std::lround(kDuelBegins_s * frame_rate_hz))),
      most_frames_(static_cast<int>(std::lround(kLongestDuel_s * frame_rate_hz))) {}

// Computes the distance to the hull only if the robot's disc is near: most robots are far away.
Duels::Nearness Duels::nearness(const sim::WorldState& now, Side side) {
  constexpr double kReach_m = kRobotRadius_m + kBallRadius_m + kDuelOver_m;
  Nearness nearness;
  for (const sim::RobotState& robot : now.robots[side]) {
    const Vec2 away_m = robot.position_m - now.ball.position_m;
    if (away_m.squaredNorm() > kReach_m * kReach_m) continue;
    nearness.is_in_it = true;
    const double gap_m =
        distance_to_hull(now.ball.position_m, robot.position_m, robot.heading) - kBallRadius_m;
    // Hysteresis: a robot joins a duel at a small gap and leaves it at a larger one.
    if (gap_m <= kDuel_m && now.ball.height_m < kRobotHeight_m) nearness.is_at_ball = true;
  }
  return nearness;
}

std::optional<Side> Duels::update(const sim::WorldState& now, const PerSide<bool>& touched,
                                  std::optional<Side> kicked) {
  const PerSide<Nearness> near{{nearness(now, Side::kWest), nearness(now, Side::kEast)}};
  if (stage_ != Stage::kOn) {
    await(near[Side::kWest].is_at_ball && near[Side::kEast].is_at_ball);
    return std::nullopt;
  }
  for (const Side side : kSides) {
    const Side other = opponent_of(side);
    const bool has_it = kicked == side || (touched[side] && !touched[other]);
    if (has_it && !near[other].is_in_it) {
      stop();
      return side;
    }
  }
  if (++frames_ >= most_frames_) stage_ = Stage::kDrawn;
  return std::nullopt;
}

void Duels::await(bool both_at_ball) {
  if (!both_at_ball) {
    stop();
  } else if (stage_ == Stage::kNone && ++frames_ >= begin_frames_) {
    stage_ = Stage::kOn;
    frames_ = 0;
  }
}

void Duels::stop() {
  stage_ = Stage::kNone;
  frames_ = 0;
}

}  // namespace autoref::game
