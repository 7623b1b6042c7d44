// The speeds of the robots and the ball in a recorded game, while the ball is in play.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "soccer/side.hpp"

namespace autoref::logs {

class LogReferee;

// The distribution of many speeds, in bins of 0.01 m/s up to 20 m/s; faster ones count as 20 m/s.
class SpeedDistribution {
 public:
  static constexpr double kBins_per_mps = 100;

  void add(double speed_mps);

  // 0 if there are none.
  double mean_mps() const;
  // The speed that the given share of all speeds does not exceed, rounded up to a bin.
  double quantile_mps(double share) const;

 private:
  std::array<std::int64_t, 2000> bins_{};
  std::int64_t count_ = 0;
  double sum_mps_ = 0;
};

struct TeamSpeeds {
  SpeedDistribution robots;  // of all robots of the team that are seen
  SpeedDistribution ball;    // of the ball while the team has touched it last
};

class SpeedCollector {
 public:
  void add(const LogReferee& referee);
  const PerSide<TeamSpeeds>& speeds() const { return speeds_; }

 private:
  PerSide<TeamSpeeds> speeds_;
};

}  // namespace autoref::logs
