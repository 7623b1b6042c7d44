#include "experiments/kinds/sweep/sweep.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "experiments/kinds/results.hpp"
#include "experiments/reading/factor_reader.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/schedule/schedule.hpp"
#include "game/settings/fields.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

// The name of a combination, as used in its games' ids: "b.handicap=0.5+match.rules=2014".
std::string combination_name(const Sweep& sweep, const std::vector<game::SettingValue>& values) {
  std::string name;
  for (std::size_t i = 0; i < values.size(); ++i) {
    name +=
        fmt::format("{}{}={}", i == 0 ? "" : "+", sweep.factors[i].path, game::spelt(values[i]));
  }
  return name;
}

ScheduledGame scheduled(const Sweep& sweep, const std::vector<game::SettingValue>& values,
                        const SharedSettings& settings, int pair, int leg) {
  return {game_id(combination_name(sweep, values), pair, leg),
          game::spelt(values),
          pair,
          leg,
          settings.with(leg_of(sweep.seed, pair, leg)),
          game::name_of(settings.a()),
          game::name_of(settings.b())};
}

SharedSettings settings_of(const Sweep& sweep, const std::vector<game::SettingValue>& values) {
  game::GameSettings game = configured(sweep.base, sweep.factors, values);
  refuse_network(game.a, "teams.a");
  refuse_network(game.b, "teams.b");
  refuse_game_controller(game);
  return SharedSettings(std::move(game));
}

std::vector<std::size_t> playing_order(const Sweep& sweep) {
  std::vector<std::size_t> sizes;
  sizes.reserve(sweep.factors.size());
  for (const Factor& factor : sweep.factors) sizes.push_back(factor.values.size());
  return combinations_order(sizes);
}

// Counts in floating point, since the product of many factors could overflow an integer.
double games_in(const Sweep& sweep) {
  double games = 2.0 * sweep.pairs;
  for (const Factor& factor : sweep.factors) games *= static_cast<double>(factor.values.size());
  return games;
}

Key factors_key(Sweep& sweep) {
  Key key{"factors", "lists of values by path",
          "what varies, such as `b.handicap: [1.0, 0.8]`; the first value is the baseline"};
  key.read = [&sweep](TopReader& top) {
    sweep.factors =
        FactorReader(top.file(), top.locations()).read(top.required("factors"), sweep.base);
    for (const Factor& factor : sweep.factors) top.refuse_assignment(factor.path);
  };
  key.text = [&sweep] {
    std::string text = "factors:\n";
    for (const Factor& factor : sweep.factors)
      text += fmt::format("  {}: [{}]\n", factor.path, io::listed(game::spelt(factor.values)));
    return text;
  };
  return key;
}

}  // namespace

constinit const Kind Sweep::kKind = {
    "sweep", "Every combination of the factors' values, played with the same seeds.", make};

std::vector<Key> Sweep::keys() {
  const auto varied_now = [this] { return factors; };
  return {base_key(base, varied_now), factors_key(*this), set_by_values_key(base, varied_now),
          pairs_key(pairs, "pairs of legs per combination"), seed_key(seed)};
}

std::vector<ScheduledGame> Sweep::games() const {
  refuse_too_many(games_in(*this));
  const std::vector<std::vector<game::SettingValue>> all = combinations(factors);
  std::vector<SharedSettings> settings;
  settings.reserve(all.size());
  for (const std::vector<game::SettingValue>& values : all)
    settings.push_back(settings_of(*this, values));
  return games_in_turns(playing_order(*this), pairs, [&](std::size_t i, int pair, int leg) {
    return scheduled(*this, all[i], settings[i], pair, leg);
  });
}

std::vector<std::string> Sweep::value_columns() const {
  std::vector<std::string> paths;
  paths.reserve(factors.size());
  for (const Factor& factor : factors) paths.push_back(factor.path);
  return paths;
}

ExperimentResults Sweep::results(const RowsById& rows) const {
  ExperimentResults results;
  results.groups = grouped(factors, rows);
  results.are_compared_with_first = results.groups.size() > 1;
  results.slope = slope_over_factor(factors, results.groups);
  results.files = {{"summary.csv", "a row per value", summary_csv(factors, results.groups)}};
  results.table = summary_table(factors, results.groups, results.slope);
  results.effects = effects_of(factors, results.groups);
  if (!results.effects.empty()) {
    results.files.push_back(
        {"effects.csv", "a row per effect of the factors", effects_csv(results.effects)});
    results.table.emplace_back("\n");
    for (auto& block : effects_table(results.effects)) results.table.push_back(std::move(block));
  }
  results.shown = {groups_progress_table(summary_rows(factors, results.groups), {}, "values")};
  results.shown.front().text = slope_text(factors, results.slope);
  results.json = std::make_shared<io::Json>(io::Json{{"groups", json_of(results.groups)}});
  return results;
}

}  // namespace autoref::experiments
