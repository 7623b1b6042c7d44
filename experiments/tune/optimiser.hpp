// Optimisers of a noisy score over a box, such as the goal difference of a team with these
// parameters.
//
// They know nothing of games: ask() gives the points to score, tell() takes the scores. An
// optimiser has no other input than its seed and the scores, so a path is repeated by repeating the
// scores.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace autoref::experiments {

// One parameter, in units of its step: the distance over which its effect is looked for first.
struct Axis {
  double low = 0;
  double high = 1;
  double start = 0;               // low to high
  double least_perturbation = 0;  // SPSA looks at least this far: half a whole number
};

using Point = Eigen::VectorXd;  // a coordinate per axis

// A point to score, and its name in this iteration: "plus", "x03".
struct Candidate {
  std::string name;
  Point point;  // within the box
};

// The mean score of a candidate; nullopt if nothing is known about it.
using Score = std::optional<double>;

class Optimiser {
 public:
  virtual ~Optimiser() = default;

  // The candidates of the current iteration, in a fixed number and order.
  virtual std::vector<Candidate> ask() const = 0;

  // Ends the iteration with the candidates' scores, in their order. Higher is better. Optimisers
  // use differences of scores only.
  virtual void tell(std::span<const Score> scores) = 0;

  // Where the search is now, and the best point as known so far. Both are within the box.
  virtual Point centre() const = 0;
  virtual Point best() const = 0;

  // How far from the centre the candidates are now, in steps.
  virtual double reach() const = 0;
};

enum class Method : std::uint8_t { kSpsa, kCmaEs };

struct Search {
  Method method = Method::kSpsa;
  int iterations = 100;
  double gain = 0.3;  // of SPSA; see spsa.hpp
  std::uint64_t seed = 1;
};

// Throws std::invalid_argument if there are no axes or a start is outside its box.
std::unique_ptr<Optimiser> make_optimiser(const Search& search, const std::vector<Axis>& axes);

// The starts of the axes.
Point start_of(const std::vector<Axis>& axes);

// The point of the box that is nearest.
Point clipped(const Point& point, const std::vector<Axis>& axes);

// The mean of the last half of a path. Single points of a path wander with the noise of the scores;
// their mean does not (Polyak and Juditsky, Acceleration of stochastic approximation by averaging,
// SIAM J. Control Optim. 30, 1992). The first half is left out, since it depends on the start.
class TailMean {
 public:
  explicit TailMean(Point start) : sums_({Point::Zero(start.size())}), start_(std::move(start)) {}

  void add(const Point& point) { sums_.push_back(sums_.back() + point); }

  // Of the points added so far; the start if there are none.
  Point value() const {
    const std::size_t count = sums_.size() - 1;
    if (count == 0) return start_;
    const std::size_t before = count / 2;
    return (sums_[count] - sums_[before]) / static_cast<double>(count - before);
  }

 private:
  std::vector<Point> sums_;  // of the first 0, 1, 2, ... points
  Point start_;
};

}  // namespace autoref::experiments
