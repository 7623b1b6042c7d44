#include "experiments/tune/optimiser.hpp"

#include <algorithm>
#include <stdexcept>

#include "experiments/tune/cma_es.hpp"
#include "experiments/tune/spsa.hpp"

namespace autoref::experiments {

Point start_of(const std::vector<Axis>& axes) {
  Point start(static_cast<Eigen::Index>(axes.size()));
  for (std::size_t i = 0; i < axes.size(); ++i) start[static_cast<Eigen::Index>(i)] = axes[i].start;
  return start;
}

Point clipped(const Point& point, const std::vector<Axis>& axes) {
  Point inside = point;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    double& coordinate = inside[static_cast<Eigen::Index>(i)];
    coordinate = std::clamp(coordinate, axes[i].low, axes[i].high);
  }
  return inside;
}

std::unique_ptr<Optimiser> make_optimiser(const Search& search, const std::vector<Axis>& axes) {
  if (axes.empty()) throw std::invalid_argument("there is nothing to tune");
  for (const Axis& axis : axes) {
    if (axis.low < axis.high && axis.low <= axis.start && axis.start <= axis.high) continue;
    throw std::invalid_argument("a start is outside its range");
  }
  if (search.method == Method::kCmaEs) return std::make_unique<CmaEs>(axes, search.seed);
  return std::make_unique<Spsa>(SpsaGains{search.iterations, search.gain}, axes, search.seed);
}

}  // namespace autoref::experiments
