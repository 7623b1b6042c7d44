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

// A factor's value, as written in the groups' values.
struct FactorLevel {
  std::string factor;
  std::string value;
  bool operator==(const FactorLevel&) const = default;
};

// Main effect: the change of the goal difference "a minus b" per game from a factor's first value
// to another one, averaged over all combinations of the other factors. With `other`, it is an
// interaction: the change of the factor's effect from the other factor's first value to another
// one. An interaction is 0 if the effects of the two factors add up.
struct Effect {
  FactorLevel level;
  std::optional<FactorLevel> other;
  std::size_t pairs = 0;             // number of pairs used: those without a void or missing leg
  double mean = 0;                   // goals per game
  std::optional<Interval> interval;  // 95 %; nullopt for one pair, or if all pairs agree
  std::optional<double> p;           // nullopt without an interval
  std::optional<double> p_holm;      // Holm's correction over all effects with a p
};

// All main effects, then all interactions of two factors, in the sweep's order. Pairs with the same
// number have the same seeds at every combination, so each pair number gives one value of each
// effect. These values are an independent sample, which gives Student's t interval and test.
// Returns nothing unless the sweep has at least two factors with two or more values each and at
// least one pair number has a game at every combination.
std::vector<Effect> effects_of(const std::vector<Factor>& factors,
                               const std::vector<Group>& groups);

// "b.robots 5", or "b.robots 5, b.handicap 0.8".
std::string effect_name(const Effect& effect);

// effects.csv: one row per effect.
std::string effects_csv(const std::vector<Effect>& effects);

// The effects as a text table; empty without effects. Interactions are left out if there are too
// many for a screen.
io::TextBlocks effects_table(const std::vector<Effect>& effects);

}  // namespace autoref::experiments
