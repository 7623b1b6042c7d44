#include "logs/compare/game_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "logs/fit/estimate.hpp"
#include "soccer/random.hpp"

namespace autoref::logs {
namespace {

constexpr int kDraws = 400;
constexpr std::uint64_t kDrawSeed = 96;
// A measure is compared if both recordings have at least this many values in this many blocks. Of
// events, as many as this must be expected in the shorter one if both are alike.
constexpr std::int64_t kComparedValues = 10;
constexpr std::ptrdiff_t kComparedBlocks = 4;
constexpr double kComparedEvents = 5;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

using Distances = std::array<double, kMeasureCount>;  // kMissing: nothing to compare
using Blocks = std::vector<AllCounts>;

constexpr double kSecondsPerMinute = 60;

double rate_of(const MeasureCounts& counts) {
  return static_cast<double>(counts.values()) * kSecondsPerMinute / counts.duration_s();
}

double rate_distance(double one, double other) {
  return one + other > 0 ? std::abs(one - other) / (one + other) : 0;
}

bool has_something(const MeasureEntry& entry, const MeasureCounts& counts) {
  constexpr double kNothing_s = 1e-6;  // what rounding may leave of differences
  return entry.kind == MeasureKind::kRate ? counts.duration_s() > kNothing_s : counts.values() > 0;
}

Distances distances_between(const AllCounts& one, const AllCounts& other) {
  Distances distances{};
  for (std::size_t i = 0; i < kMeasureCount; ++i)
    distances[i] = distance_between(kMeasures[i], one[i], other[i]).value_or(kMissing);
  return distances;
}

AllCounts sum_of(const Blocks& blocks, std::span<const std::size_t> chosen) {
  AllCounts sum;
  for (const std::size_t i : chosen) sum = std::move(sum) + blocks[i];
  return sum;
}

AllCounts drawn_again(const Blocks& blocks, RandomStream& random) {
  std::vector<std::size_t> chosen(blocks.size());
  std::generate(chosen.begin(), chosen.end(), [&] { return random() % blocks.size(); });
  return sum_of(blocks, chosen);
}

std::vector<Distances> bootstrap_draws(const Blocks& recorded, const Blocks& simulated) {
  RandomStream random(kDrawSeed);
  std::vector<Distances> draws(kDraws);
  for (Distances& draw : draws) {
    const AllCounts one = drawn_again(recorded, random);
    draw = distances_between(one, drawn_again(simulated, random));
  }
  return draws;
}

double running_s(const AllCounts& counts) {
  return counts[static_cast<std::size_t>(Measure::kFouls)].duration_s();
}

// Distances if which block belongs to which recording is left to chance. Blocks differ in how much
// they have of running play, which is what nearly all measures look at.
std::vector<Distances> chance_draws(const Blocks& recorded, const Blocks& simulated,
                                    double shorter_s) {
  RandomStream random(kDrawSeed + 1);
  Blocks all = recorded;
  all.insert(all.end(), simulated.begin(), simulated.end());
  std::vector<std::size_t> indices(all.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  const AllCounts total = sum_of(all, indices);
  std::vector<Distances> draws(kDraws);
  for (Distances& draw : draws) {
    std::size_t count = 0;
    double drawn_s = 0;
    while (count < indices.size()) {
      std::swap(indices[count], indices[count + random() % (indices.size() - count)]);
      const double block_s = running_s(all[indices[count]]);
      if (drawn_s + block_s / 2 > shorter_s) break;
      drawn_s += block_s;
      ++count;
    }
    const AllCounts part = sum_of(all, std::span(indices).first(count));
    draw = distances_between(part, total - part);
  }
  return draws;
}

std::ptrdiff_t blocks_with(std::size_t measure, const Blocks& blocks) {
  return std::count_if(blocks.begin(), blocks.end(), [&](const AllCounts& counts) {
    return has_something(kMeasures[measure], counts[measure]);
  });
}

bool is_enough(std::size_t measure, const MeasureCounts& one, const MeasureCounts& other) {
  if (kMeasures[measure].kind != MeasureKind::kRate)
    return std::min(one.values(), other.values()) >= kComparedValues;
  const double sum_s = one.duration_s() + other.duration_s();
  return static_cast<double>(one.values() + other.values()) *
             std::min(one.duration_s(), other.duration_s()) >=
         kComparedEvents * sum_s;
}

MeasuredValue measured_value(const MeasureEntry& entry, const MeasureCounts& counts) {
  MeasuredValue value{counts.values(), std::nullopt};
  if (!has_something(entry, counts)) return value;
  switch (entry.kind) {
    case MeasureKind::kDistribution:
      value.typical = quantile_of(entry, counts, 0.5);
      break;
    case MeasureKind::kShare:
      value.typical =
          static_cast<double>(counts.bins().back()) / static_cast<double>(counts.values());
      break;
    case MeasureKind::kRate:
      value.typical = rate_of(counts);
      break;
  }
  return value;
}

// The mean of some distances, without those that are missing.
double mean_of(const Distances& distances, const std::vector<std::size_t>& measures) {
  double sum = 0;
  int count = 0;
  for (const std::size_t i : measures) {
    if (std::isnan(distances[i])) continue;
    sum += distances[i];
    ++count;
  }
  return count > 0 ? sum / count : kMissing;
}

double without_chance(double distance, double chance2) {
  return std::sqrt(std::max(distance * distance - chance2, 0.0));
}

// The distance `value` less what chance contributes; `of` gives a draw's distance. A distance drawn
// again contains chance twice: that of the recordings and that of the draw.
template <typename Of>
std::optional<Distance> distance_from(double value, const std::vector<Distances>& again,
                                      const std::vector<Distances>& by_chance, const Of& of) {
  constexpr double kTail = 0.025;
  double sum2 = 0;
  int count = 0;
  for (const Distances& draw : by_chance) {
    const double drawn = of(draw);
    if (std::isnan(drawn)) continue;
    sum2 += drawn * drawn;
    ++count;
  }
  if (count == 0) return std::nullopt;
  const double chance2 = sum2 / count;
  std::vector<double> drawn;
  drawn.reserve(again.size());
  for (const Distances& draw : again) {
    if (!std::isnan(of(draw))) drawn.push_back(without_chance(of(draw), 2 * chance2));
  }
  if (drawn.empty()) return std::nullopt;
  const double distance = without_chance(value, chance2);
  const double half =
      std::max(distance - quantile(drawn, kTail), quantile(drawn, 1 - kTail) - distance);
  return Distance{distance, std::max(distance - half, 0.0), std::min(distance + half, 1.0)};
}

}  // namespace

std::optional<double> distance_between(const MeasureEntry& entry, const MeasureCounts& one,
                                       const MeasureCounts& other) {
  if (!has_something(entry, one) || !has_something(entry, other)) return std::nullopt;
  if (entry.kind == MeasureKind::kRate) return rate_distance(rate_of(one), rate_of(other));
  double largest = 0;
  std::int64_t below_one = 0;
  std::int64_t below_other = 0;
  for (std::size_t i = 0; i < one.bins().size(); ++i) {
    below_one += one.bins()[i];
    below_other += other.bins()[i];
    largest = std::max(
        largest, std::abs(static_cast<double>(below_one) / static_cast<double>(one.values()) -
                          static_cast<double>(below_other) / static_cast<double>(other.values())));
  }
  return largest;
}

double quantile_of(const MeasureEntry& entry, const MeasureCounts& counts, double share) {
  const double width = entry.highest / static_cast<double>(counts.bins().size());
  const double wanted = share * static_cast<double>(counts.values());
  double below = 0;
  std::size_t bin = 0;
  while (bin + 1 < counts.bins().size() && below + static_cast<double>(counts.bins()[bin]) < wanted)
    below += static_cast<double>(counts.bins()[bin++]);
  const auto here = static_cast<double>(std::max<std::int64_t>(counts.bins()[bin], 1));
  return (static_cast<double>(bin) + (wanted - below) / here) * width;
}

GameComparison comparison_of(const MeasuredGames& recorded, const MeasuredGames& simulated) {
  const Blocks recorded_blocks = recorded.blocks();
  const Blocks simulated_blocks = simulated.blocks();
  const AllCounts one = recorded.total();
  const AllCounts other = simulated.total();
  const std::vector<Distances> again = bootstrap_draws(recorded_blocks, simulated_blocks);
  const std::vector<Distances> by_chance =
      chance_draws(recorded_blocks, simulated_blocks, std::min(running_s(one), running_s(other)));
  const Distances distances = distances_between(one, other);

  GameComparison comparison;
  std::vector<std::size_t> compared;
  for (std::size_t i = 0; i < kMeasureCount; ++i) {
    MeasureComparison& measure = comparison.measures.emplace_back();
    measure.measure = kMeasures[i].measure;
    measure.recorded = measured_value(kMeasures[i], one[i]);
    measure.simulated = measured_value(kMeasures[i], other[i]);
    if (!is_enough(i, one[i], other[i]) ||
        std::min(blocks_with(i, recorded_blocks), blocks_with(i, simulated_blocks)) <
            kComparedBlocks)
      continue;
    measure.distance = distance_from(distances[i], again, by_chance,
                                     [&](const Distances& draw) { return draw[i]; });
    if (measure.distance) compared.push_back(i);
  }
  const auto mean = [&](const Distances& draw) { return mean_of(draw, compared); };
  comparison.compared = static_cast<int>(compared.size());
  if (!compared.empty()) comparison.mean = distance_from(mean(distances), again, by_chance, mean);
  return comparison;
}

}  // namespace autoref::logs
