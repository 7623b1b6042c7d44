// The effect of each factor of a sweep, and the interactions between factors.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/schedule/factor.hpp"
#include "experiments/statistics/interval.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// A value of a factor, as written in the groups.
struct FactorLevel {
  std::string factor;
  std::string value;
  bool operator==(const FactorLevel&) const = default;
};

// The change of "a minus b" in goals per game from a factor's first value to another one, averaged
// over all combinations of the other factors (main effect). With `other`, the change of this
// effect from the first value of the other factor to another one (interaction): 0 if the two
// factors add up.
struct Effect {
  FactorLevel level;
  std::optional<FactorLevel> other;
  std::size_t pairs = 0;             // pair numbers without a void or missing leg
  double mean = 0;                   // goals per game
  std::optional<Interval> interval;  // 95 %; nullopt for one pair, or if all pairs agree
  std::optional<double> p;           // nullopt if there is no interval
  std::optional<double> p_holm;      // Holm's correction over all effects with a p
};

// All main effects, then all interactions of two factors, in the sweep's order. Pairs with the same
// number have the same seeds at every combination, so each pair number gives one value of each
// effect. These values are an independent sample, which gives Student's t interval and test.
// Returns nothing unless the sweep has at least two factors with two or more values each and some
// pair number has all its games.
std::vector<Effect> effects_of(const std::vector<Factor>& factors,
                               const std::vector<Group>& groups);

// "b.robots 5", or "b.robots 5, b.handicap 0.8".
std::string effect_name(const Effect& effect);

// effects.csv: one row per effect.
std::string effects_csv(const std::vector<Effect>& effects);

// The text table, without interactions if there are too many for a screen. Empty without effects.
io::TextBlocks effects_table(const std::vector<Effect>& effects);

}  // namespace autoref::experiments
