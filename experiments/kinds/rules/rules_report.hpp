// What each variant of the rules changes in the games, as a CSV file, JSON and text tables.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/results.hpp"
#include "experiments/kinds/rules/rules_experiment.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// A measure of the games under one variant. The games with the same pair number, of all matchups,
// have the same seeds and together give one value; the mean and its 95 % interval are over pair
// numbers, without those that have a void or missing game.
struct RuleEffect {
  std::string measure;  // as in summary.csv: "stops_per_min", "calls_goal"
  std::string variant;
  std::size_t pairs = 0;
  std::optional<double> mean;        // nullopt without pairs
  std::optional<Interval> interval;  // Student's; nullopt for one pair, or if all pairs agree
  PairedDifference from_first;       // empty for the first variant
};

struct RuleEffects {
  std::vector<std::string> variants;
  std::vector<std::string> settings;  // of each variant: "match.rule.dribbling_m=2"; may be empty
  std::vector<std::size_t> pairs;     // of each variant: pair numbers that have all their games
  std::vector<std::string> heads;     // heading of each measure: "stops per minute in play"
  std::vector<RuleEffect> effects;    // of every measure, all variants
  std::vector<Matchup> matchups;      // team a is the stronger team
  int void_games = 0;
};

// The measures, in this order: stops per minute in play, time in play per game and as a
// percentage of the whole time, goals and shots of both teams per game, the lead of the stronger
// team per game, calls per game, doubtful calls (game::kDoubtfulBelow) as a percentage of all
// calls, and the calls per game of each kind that occurred in any game. The stronger team of a
// matchup is the one with more goals in the games under all variants together. Every difference is
// from the first variant, and Holm's correction is over all measures and variants.
RuleEffects rule_effects_of(const RulesExperiment& rules, const RowsById& rows);

// summary.csv: one row per measure and variant.
std::string csv_of(const RuleEffects& effects);

// [{"measure": "goals", "variant": "official", "pairs": 20, "mean": 3.41, ...}, ...], with the
// columns of summary.csv except `p`, `p_holm` and `effect_size`.
io::Json json_of(const RuleEffects& effects);

// One row per measure, with the first variant and two others side by side; further variants are in
// tables below. Explanations follow.
io::TextBlocks table_of(const RuleEffects& effects);
io::ProgressTable progress_table_of(const RuleEffects& effects);

}  // namespace autoref::experiments
