#include "logs/speeds.hpp"

#include <algorithm>

#include "logs/log_referee.hpp"

namespace autoref::logs {

void SpeedDistribution::add(double speed_mps) {
  const double bin = std::min(speed_mps * kBins_per_mps, static_cast<double>(bins_.size() - 1));
  ++bins_[static_cast<std::size_t>(bin)];
  ++count_;
  sum_mps_ += speed_mps;
}

double SpeedDistribution::mean_mps() const {
  return count_ == 0 ? 0 : sum_mps_ / static_cast<double>(count_);
}

double SpeedDistribution::quantile_mps(double share) const {
  if (count_ == 0) return 0;
  const double wanted = share * static_cast<double>(count_);
  std::int64_t so_far = 0;
  std::size_t bin = 0;
  while (bin + 1 < bins_.size() && static_cast<double>(so_far += bins_[bin]) < wanted) ++bin;
  return static_cast<double>(bin + 1) / kBins_per_mps;
}

void SpeedCollector::add(const LogReferee& referee) {
  if (!referee.referee().is_ball_in_play()) return;
  const Tracks& tracks = referee.referee().tracks();
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : tracks.robots[side])
      if (robot.is_seen) speeds_[side].robots.add(robot.velocity_mps.norm());
  }
  const std::optional<Side> last = referee.referee().last_touch().side;
  if (last && tracks.ball && referee.referee().frame().ball)
    speeds_[*last].ball.add(tracks.ball->velocity_mps.norm());
}

}  // namespace autoref::logs
