// Sights of an object in consecutive frames.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "logs/fit/recorded_motion.hpp"
#include "logs/third_differences.hpp"
#include "soccer/geometry.hpp"

namespace autoref::logs {

template <typename Sight>
Vec2 third_difference_m(std::span<const Sight> sights) {
  return third_difference<Vec2>(sights[0].position_m, sights[1].position_m, sights[2].position_m,
                                sights[3].position_m);
}

template <typename Sight>
bool is_seen_by_one_camera(std::span<const Sight> sights) {
  return std::all_of(sights.begin(), sights.end(), [&](const Sight& sight) {
    return sight.is_seen && sight.camera == sights.front().camera;
  });
}

}  // namespace autoref::logs
