#include "experiments/kinds/judge/dealt_matchups.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

using Indices = std::vector<std::size_t>;

// Fisher and Yates; std::shuffle differs between libraries.
template <typename Values>
void shuffle(Values& values, RandomStream& random) {
  for (std::size_t left = values.size(); left > 1; --left) {
    const auto chosen = static_cast<std::size_t>(random.uniform() * static_cast<double>(left));
    std::swap(values[left - 1], values[chosen]);
  }
}

Indices shuffled(std::size_t count, RandomStream& random) {
  Indices indices(count);
  std::iota(indices.begin(), indices.end(), 0U);
  shuffle(indices, random);
  return indices;
}

class Deal {
 public:
  Deal(const std::vector<std::string>& teams, std::uint64_t seed) : teams_(teams), random_(seed) {
    const std::size_t n = teams.size();
    swaps_.reserve(n * n);
    for (std::size_t i = 0; i < n * n; ++i) swaps_.push_back(random_.uniform() < 0.5);
  }

  // Appends every pair once.
  void add_cycle(std::vector<std::array<std::string, 2>>& dealt) {
    const std::size_t n = teams_.size();
    const Indices labels = shuffled(n, random_);
    for (const std::size_t round : shuffled(n, random_)) {
      for (const auto& [i, j] : pairs_of_round(round)) add(labels[i], labels[j], dealt);
    }
    is_odd_cycle_ = !is_odd_cycle_;
  }

 private:
  // All i <= j with i + j = round (mod n): every team meets one opponent or itself, and over all n
  // rounds each pair occurs once.
  std::vector<std::pair<std::size_t, std::size_t>> pairs_of_round(std::size_t round) {
    const std::size_t n = teams_.size();
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    pairs.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (round + n - i) % n;
      if (i <= j) pairs.emplace_back(i, j);
    }
    shuffle(pairs, random_);
    return pairs;
  }

  void add(std::size_t i, std::size_t j, std::vector<std::array<std::string, 2>>& dealt) const {
    const auto [low, high] = std::minmax(i, j);
    const bool is_swapped = swaps_[low * teams_.size() + high] != is_odd_cycle_;
    dealt.push_back({teams_[is_swapped ? high : low], teams_[is_swapped ? low : high]});
  }

  const std::vector<std::string>& teams_;
  RandomStream random_;
  std::vector<bool> swaps_;  // by pair: its order in even cycles
  bool is_odd_cycle_ = false;
};

}  // namespace

std::vector<std::array<std::string, 2>> dealt_matchups(const std::vector<std::string>& teams,
                                                       std::uint64_t seed, std::size_t count) {
  assert(!teams.empty());
  std::vector<std::array<std::string, 2>> dealt;
  Deal deal(teams, seed);
  while (dealt.size() < count) deal.add_cycle(dealt);
  dealt.resize(count);
  return dealt;
}

}  // namespace autoref::experiments
