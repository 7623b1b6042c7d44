#include "experiments/schedule/playing_order.hpp"

#include <algorithm>
#include <numeric>

namespace autoref::experiments {
namespace {

// The matchups of `teams` teams, collected as indices into matchups_of(RoundRobin).
class MatchupOrder {
 public:
  explicit MatchupOrder(std::size_t teams) : teams_(teams) {
    indices_.reserve(teams * (teams - 1) / 2);
  }

  void add(std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax(a, b);
    // Each team before `low` is the first of its matchups with all teams after it.
    indices_.push_back(low * (2 * teams_ - low - 1) / 2 + high - low - 1);
  }

  std::vector<std::size_t> indices() && { return std::move(indices_); }

 private:
  std::size_t teams_;
  std::vector<std::size_t> indices_;
};

// The first team stays in its place.
std::vector<std::size_t> circle_order(std::size_t teams) {
  const std::size_t moving = teams - 1;
  MatchupOrder order(teams);
  for (std::size_t round = 0; round < moving; ++round) {
    for (std::size_t i = 0; i < teams / 2; ++i) {
      // The first team does not always begin, so that it is not always in the same shard.
      const std::size_t k = (round + i) % (teams / 2);
      const std::size_t other = k == 0 ? 0 : 1 + (round + moving - k) % moving;
      order.add(1 + (round + k) % moving, other);
    }
  }
  return std::move(order).indices();
}

// A zigzag through the teams on a circle, and the first team at its ends.
std::vector<std::size_t> walecki_cycle(std::size_t teams, std::size_t turn) {
  const std::size_t on_circle = teams - 1;
  std::vector<std::size_t> cycle = {0, 1 + turn};
  for (std::size_t k = 1; k < on_circle / 2; ++k) {
    cycle.push_back(1 + (turn + k) % on_circle);
    cycle.push_back(1 + (turn + on_circle - k) % on_circle);
  }
  cycle.push_back(1 + (turn + on_circle / 2) % on_circle);
  return cycle;
}

std::vector<std::size_t> cycles_order(std::size_t teams) {
  MatchupOrder order(teams);
  for (std::size_t turn = 0; turn < teams / 2; ++turn) {
    const std::vector<std::size_t> cycle = walecki_cycle(teams, turn);
    for (const std::size_t start : {0, 1}) {
      for (std::size_t i = start; i < teams; i += 2) order.add(cycle[i], cycle[(i + 1) % teams]);
    }
  }
  return std::move(order).indices();
}

}  // namespace

std::vector<std::size_t> round_robin_order(std::size_t teams) {
  if (teams < 2) return {};
  return teams % 2 == 0 ? circle_order(teams) : cycles_order(teams);
}

// Combines the order so far with one list after the other. Both run through their values over and
// over, which repeats after their least common multiple; from there on, the list is shifted by one.
std::vector<std::size_t> combinations_order(const std::vector<std::size_t>& sizes) {
  std::vector<std::size_t> order = {0};
  for (const std::size_t size : sizes) {
    const std::size_t period = std::lcm(order.size(), size);
    std::vector<std::size_t> longer;
    longer.reserve(order.size() * size);
    for (std::size_t i = 0; i < order.size() * size; ++i) {
      longer.push_back(order[i % order.size()] * size + (i + i / period) % size);
    }
    order = std::move(longer);
  }
  return order;
}

}  // namespace autoref::experiments
