// The search of a family of situations: its axes, and the situations at points of the search.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "experiments/scenes/situation.hpp"
#include "experiments/tune/optimiser.hpp"
#include "soccer/field.hpp"

namespace autoref::experiments {

// Paths of the values that are given as ranges, such as "ball.x_m" and "defenders.2.y_m": one axis
// of the search each.
std::vector<std::string> searched_paths(const SituationSetup& family, const Field& field);

// CMA-ES over the family's ranges, from a point drawn uniformly with `seed`. The first standard
// deviation is a quarter of each range.
std::unique_ptr<Optimiser> optimiser_of(const SituationSetup& family, const Field& field,
                                        int iterations, std::uint64_t seed);

// The part of the family around a point: each range is reduced to `spread` times its width, around
// the point's value, rounded to thousandths, and within the family's range.
SituationSetup situation_at(const SituationSetup& family, const Field& field, const Point& point,
                            double spread);

// A robot of a situation.
struct RobotOfSituation {
  bool is_attacker = true;
  int number = 0;
  bool operator==(const RobotOfSituation&) const = default;
};

// "attackers.3".
std::string path_of(const RobotOfSituation& robot);

// All robots: attackers first, then by number.
std::vector<RobotOfSituation> robots_of(const SituationSetup& situation);

SituationSetup situation_without(SituationSetup situation, const RobotOfSituation& robot);
SituationSetup situation_without(SituationSetup situation,
                                 const std::vector<RobotOfSituation>& robots);

}  // namespace autoref::experiments
