#include "experiments/analysis/effects.hpp"

#include <algorithm>

#include "experiments/analysis/groups.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {
namespace {

constexpr std::size_t kMostShown = 40;

// Each factor's value, as an index into its list of values; 0 is the first.
using Levels = std::vector<std::size_t>;

// A sweep's combinations as levels of each factor.
struct Design {
  std::vector<std::vector<std::string>> values;  // values by factor, in the sweep's order
  std::vector<Levels> groups;                    // levels by group
};

Design design_of(const std::vector<Group>& groups) {
  Design design;
  design.values.resize(groups.front().values.size());
  for (const Group& group : groups) {
    Levels levels;
    for (std::size_t factor = 0; factor < group.values.size(); ++factor) {
      std::vector<std::string>& known = design.values[factor];
      const auto found = std::find(known.begin(), known.end(), group.values[factor]);
      levels.push_back(static_cast<std::size_t>(found - known.begin()));
      if (found == known.end()) known.push_back(group.values[factor]);
    }
    design.groups.push_back(std::move(levels));
  }
  return design;
}

// The differences of each pair number in all groups. Skips pair numbers with a missing game.
std::vector<std::vector<double>> complete_pairs(const std::vector<Group>& groups) {
  std::vector<std::vector<double>> pairs;
  for (const auto& [number, first] : groups.front().pair_differences) {
    std::vector<double> differences;
    for (const Group& group : groups) {
      const auto found = group.pair_differences.find(number);
      if (found != group.pair_differences.end()) differences.push_back(found->second);
    }
    if (differences.size() == groups.size()) pairs.push_back(std::move(differences));
  }
  return pairs;
}

struct FactorAndLevel {
  std::size_t factor = 0;
  std::size_t level = 0;

  // 1 at this level, -1 at the first one, 0 at any other.
  double sign_in(const Levels& levels) const {
    return levels[factor] == level ? 1 : levels[factor] == 0 ? -1 : 0;
  }
};

// The weights of the groups in an effect. All signs occur equally often, since a sweep plays every
// combination.
std::vector<double> weights_of(const Design& design, const std::vector<FactorAndLevel>& parts) {
  std::vector<double> weights;
  for (const Levels& levels : design.groups) {
    double sign = 1;
    for (const FactorAndLevel& part : parts) sign *= part.sign_in(levels);
    weights.push_back(sign);
  }
  const auto used = std::count_if(weights.begin(), weights.end(), [](double w) { return w != 0; });
  const double signs = parts.size() == 1 ? 2 : 4;
  for (double& weight : weights) weight *= signs / static_cast<double>(used);
  return weights;
}

FactorLevel level_of(const std::vector<Factor>& factors, const Design& design,
                     const FactorAndLevel& part) {
  return {factors[part.factor].path, design.values[part.factor][part.level]};
}

Effect effect_of(const std::vector<Factor>& factors, const Design& design,
                 const std::vector<std::vector<double>>& pairs,
                 const std::vector<FactorAndLevel>& parts) {
  const std::vector<double> weights = weights_of(design, parts);
  std::vector<double> sample;
  for (const std::vector<double>& differences : pairs) {
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * differences[i];
    sample.push_back(sum);
  }
  Effect effect;
  effect.level = level_of(factors, design, parts.front());
  if (parts.size() > 1) effect.other = level_of(factors, design, parts.back());
  effect.pairs = sample.size();
  effect.mean = mean(sample);
  effect.interval = mean_interval(sample);
  effect.p = p_of_zero_mean(sample);
  return effect;
}

std::vector<FactorAndLevel> later_levels(const Design& design) {
  std::vector<FactorAndLevel> all;
  for (std::size_t factor = 0; factor < design.values.size(); ++factor)
    for (std::size_t level = 1; level < design.values[factor].size(); ++level)
      all.push_back({factor, level});
  return all;
}

FactorLevel other_level(const Effect& effect) { return effect.other.value_or(FactorLevel{}); }

io::TableColumns<Effect> effect_columns() {
  const io::TableColumns<Effect> first = {
      {"factor", [](const Effect& effect) { return effect.level.factor; }},
      {"value", [](const Effect& effect) { return effect.level.value; }},
      {"other_factor", [](const Effect& effect) { return other_level(effect).factor; }},
      {"other_value", [](const Effect& effect) { return other_level(effect).value; }},
      {"pairs", [](const Effect& effect) { return static_cast<int>(effect.pairs); }},
      {"mean", &Effect::mean}};
  const io::TableColumns<Effect> last = {
      {"p", [](const Effect& effect) { return p_cell(effect.p); }},
      {"p_holm", [](const Effect& effect) { return p_cell(effect.p_holm); }}};
  return io::joined(first, interval_columns<Effect>("", &Effect::interval), last);
}

}  // namespace

std::vector<Effect> effects_of(const std::vector<Factor>& factors,
                               const std::vector<Group>& groups) {
  if (factors.size() < 2 || groups.empty()) return {};
  const Design design = design_of(groups);
  const auto varied =
      std::count_if(design.values.begin(), design.values.end(),
                    [](const std::vector<std::string>& values) { return values.size() > 1; });
  const std::vector<std::vector<double>> pairs = complete_pairs(groups);
  if (varied < 2 || pairs.empty()) return {};
  const std::vector<FactorAndLevel> levels = later_levels(design);
  std::vector<Effect> effects;
  effects.reserve(levels.size() * (levels.size() + 1) / 2);
  for (const FactorAndLevel& level : levels)
    effects.push_back(effect_of(factors, design, pairs, {level}));
  for (const FactorAndLevel& one : levels) {
    for (const FactorAndLevel& other : levels) {
      if (one.factor < other.factor)
        effects.push_back(effect_of(factors, design, pairs, {one, other}));
    }
  }
  correct_by_holm(effects);
  return effects;
}

std::string effect_name(const Effect& effect) {
  const auto text = [](const FactorLevel& level) { return level.factor + " " + level.value; };
  return effect.other ? text(effect.level) + ", " + text(*effect.other) : text(effect.level);
}

std::string effects_csv(const std::vector<Effect>& effects) {
  return io::csv_text(io::table_rows(effect_columns(), effects));
}

io::TextBlocks effects_table(const std::vector<Effect>& effects) {
  if (effects.empty()) return {};
  const bool has_all = effects.size() <= kMostShown;
  std::vector<io::Cells> rows = {{"effect", "on a minus b [95 %]", "p"}};
  for (const Effect& effect : effects) {
    if (effect.other && !has_all) break;
    rows.push_back({effect_name(effect), mean_text(effect.mean, effect.interval, effect.pairs),
                    effect.p_holm ? p_text(*effect.p_holm) : ""});
  }
  io::TextBlocks blocks = {io::TextTable{std::move(rows), {io::Align::kLeft}}};
  if (!has_all) blocks.emplace_back("Interactions: effects.csv\n");
  return blocks;
}

}  // namespace autoref::experiments
