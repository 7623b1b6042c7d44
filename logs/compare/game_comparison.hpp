// How far simulated games are from recorded ones.
//
// Between two distributions, it is the Kolmogorov-Smirnov distance: the largest difference, over
// all bounds, between the shares of values below the bound. That of two shares is their difference.
// The distance between two rates a and b is |a - b| / (a + b). All are from 0 to 1.
//
// Games that are alike also differ by chance, the more the shorter they are. What chance
// contributes is found by exchanging blocks of time between the two at random, as many as have the
// running play of the shorter one. Its mean square is subtracted from that of the distance, so that
// games alike are at a distance of about 0.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "logs/compare/measured_games.hpp"

namespace autoref::logs {

struct Distance {
  double value = 0;
  // 95 % confidence interval, from blocks drawn again at random (bootstrap). Both halves are as
  // long as the longer one, because the largest of many differences tends to be too large. If the
  // interval begins at 0, chance may explain the distance.
  double low = 0;
  double high = 0;
};

// A measure in one of the two recordings.
struct MeasuredValue {
  std::int64_t values = 0;  // frames, episodes or events
  // The median of a distribution, a share, or a rate per minute; nullopt if nothing was seen.
  std::optional<double> typical;
};

struct MeasureComparison {
  Measure measure = Measure::kBallSpeed;
  MeasuredValue recorded;
  MeasuredValue simulated;
  std::optional<Distance> distance;  // nullopt if the recordings show too little
};

struct GameComparison {
  std::vector<MeasureComparison> measures;  // all of them, in the order of Measure
  // The mean over the measures that have a distance, before what chance contributes to it is
  // subtracted; nullopt if none has.
  std::optional<Distance> mean;
  int compared = 0;  // number of these measures
};

GameComparison comparison_of(const MeasuredGames& recorded, const MeasuredGames& simulated);

// The distance of a measure, with what chance contributes; nullopt if one of the two is empty.
std::optional<double> distance_between(const MeasureEntry& entry, const MeasureCounts& one,
                                       const MeasureCounts& other);

// The value below which a share `share` of a distribution's values lies; there must be values.
double quantile_of(const MeasureEntry& entry, const MeasureCounts& counts, double share);

}  // namespace autoref::logs
