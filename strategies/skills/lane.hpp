// The segment along which a ball is kicked, for questions about many robots.
#pragma once

#include "soccer/geometry.hpp"

namespace autoref::strategies {

class Lane {
 public:
  Lane(const Vec2& from_m, const Vec2& to_m)
      : from_m_(from_m), to_m_(to_m), offset_(to_m - from_m), length2_(offset_.squaredNorm()) {}

  // Whether the point's distance from the line through both ends, squared, exceeds `distance2`, by
  // far more than rounding errors. A cheap test: if true, the distance from the lane is larger,
  // too.
  bool is_beyond(const Vec2& point_m, double distance2) const {
    return square(cross(offset_, point_m - from_m_)) >
           (distance2 * (1 + kMargin) + kMargin_m2) * length2_;
  }

  Vec2 nearest_m(const Vec2& point_m) const { return nearest_on_segment(point_m, from_m_, to_m_); }

 private:
  static constexpr double kMargin = 1e-7;
  static constexpr double kMargin_m2 = 1e-12;

  Vec2 from_m_;
  Vec2 to_m_;
  Vec2 offset_;
  double length2_;
};

}  // namespace autoref::strategies
