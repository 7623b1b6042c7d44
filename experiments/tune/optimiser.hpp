// Optimisers of a noisy score over a box, such as a team's goal difference as a function of its
// parameters.
//
// They know nothing of games: ask() gives the points to score, tell() takes the scores. An
// optimiser's only inputs are its seed and the scores, so the same scores give the same path.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace autoref::experiments {

// One parameter, in units of its step. The step is the distance over which the parameter's effect
// is first tested.
struct Axis {
  double low = 0;
  double high = 1;
  double start = 0;               // start of the search, between `low` and `high`
  double least_perturbation = 0;  // of SPSA's candidates; for whole-number parameters, 0.5 / step
};

using Point = Eigen::VectorXd;  // a coordinate per axis

// A point to score, and its name in this iteration: "plus", "x03".
struct Candidate {
  std::string name;
  Point point;  // within the box
};

// The mean score of a candidate; nullopt if none of its games counts.
using Score = std::optional<double>;

class Optimiser {
 public:
  virtual ~Optimiser() = default;

  // The candidates of the current iteration, in a fixed number and order.
  virtual std::vector<Candidate> ask() const = 0;

  // Ends the iteration with the candidates' scores, in their order. Higher is better. Optimisers
  // use only differences between scores.
  virtual void tell(std::span<const Score> scores) = 0;

  // The current position of the search, and the best point known so far. Both are within the box.
  virtual Point centre() const = 0;
  virtual Point best() const = 0;

  // The candidates' current distance from the centre, in steps.
  virtual double reach() const = 0;
};

enum class Method : std::uint8_t { kSpsa, kCmaEs };

struct Search {
  Method method = Method::kSpsa;
  int iterations = 100;
  double gain = 0.3;  // gain of SPSA; see spsa.hpp
  std::uint64_t seed = 1;
};

// Throws std::invalid_argument if there are no axes or if the start of an axis is outside its
// range.
std::unique_ptr<Optimiser> make_optimiser(const Search& search, const std::vector<Axis>& axes);

// The point at which all axes have their start values.
Point start_of(const std::vector<Axis>& axes);

// The point of the box that is nearest to `point`.
Point clipped(const Point& point, const std::vector<Axis>& axes);

// The mean of the last half of a path. Individual points of a path wander with the noise of the
// scores; their mean does not (Polyak and Juditsky, Acceleration of stochastic approximation by
// averaging, SIAM J. Control Optim. 30, 1992). The first half is left out, since it depends on the
// start.
class TailMean {
 public:
  explicit TailMean(Point start) : sums_({Point::Zero(start.size())}), start_(std::move(start)) {}

  void add(const Point& point) { sums_.push_back(sums_.back() + point); }

  // The mean for the points added so far; the start if there are none.
  Point value() const {
    const std::size_t count = sums_.size() - 1;
    if (count == 0) return start_;
    const std::size_t before = count / 2;
    return (sums_[count] - sums_[before]) / static_cast<double>(count - before);
  }

 private:
  std::vector<Point> sums_;  // sums of the first 0, 1, 2, ... points
  Point start_;
};

}  // namespace autoref::experiments
