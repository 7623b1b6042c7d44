#include "experiments/schedule/factor.hpp"

#include <set>

#include "game/settings/fields.hpp"

namespace autoref::experiments {
namespace {

struct AsNumber {
  std::optional<double> operator()(const std::string& /*word*/) const { return std::nullopt; }
  std::optional<double> operator()(auto number) const { return static_cast<double>(number); }
};

using SpeltValues = std::map<std::string, std::string>;  // values by full path

// Adds the overrides of some robots to `values`, by full path.
void add(const game::ChangesOf& of, const std::string& holder, SpeltValues& values) {
  for (const auto& [path, value] : *of.changes) {
    if (game::branch_of(path) != of.branch) continue;
    values[holder + path.substr(of.branch.size())] = game::spelt(value);
  }
}

SpeltValues values_in(game::GameSettings game) {
  SpeltValues values;
  for (const game::Setting& setting : game::settings_of(game)) {
    if (const auto* of = std::get_if<game::ChangesOf>(&setting.target))
      add(*of, setting.path, values);
    if (!game::is_alias(setting) && !game::holds_others(setting))
      values[setting.path] = game::value_of(setting);
  }
  return values;
}

// Adds the settings implied by each value of one key, except keys in `varied` and settings given in
// the base.
void add(const game::GameSettings& base, const Factor& key, const std::set<std::string>& varied,
         SetByValues& all) {
  const SpeltValues of_base = values_in(base);
  std::map<std::string, SpeltValues> found;
  // A path that one value changes is listed for every value, so that the columns are complete.
  std::set<std::string> paths;
  for (const game::SettingValue& value : key.values) {
    game::GameSettings game = base;
    game::set_value_at(game, key.path, value);
    SpeltValues& its = found[key.path + "=" + game::spelt(value)] = values_in(game);
    for (const auto& [path, text] : its) {
      const auto there = of_base.find(path);
      const bool is_same = there != of_base.end() && there->second == text;
      if (!is_same && !varied.contains(path) && !base.given.contains(path)) paths.insert(path);
    }
  }
  if (paths.empty()) return;
  for (auto& [name, values] : found) {
    std::erase_if(values, [&paths](const auto& value) { return !paths.contains(value.first); });
    all[name] = values;
  }
}

}  // namespace

std::optional<std::vector<double>> numbers_of(const Factor& factor) {
  std::vector<double> numbers;
  numbers.reserve(factor.values.size());
  for (const game::SettingValue& value : factor.values) {
    const std::optional<double> number = std::visit(AsNumber{}, value);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<std::vector<game::SettingValue>> combinations(const std::vector<Factor>& factors) {
  std::vector<std::vector<game::SettingValue>> all = {{}};
  for (const Factor& factor : factors) {
    // Cartesian product, built up one factor at a time.
    std::vector<std::vector<game::SettingValue>> longer;
    for (const std::vector<game::SettingValue>& start : all) {
      for (const game::SettingValue& value : factor.values) {
        longer.push_back(start);
        longer.back().push_back(value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

game::GameSettings configured(const game::GameSettings& base, const std::vector<Factor>& factors,
                              const std::vector<game::SettingValue>& values) {
  game::GameSettings game = base;
  for (std::size_t i = 0; i < values.size(); ++i)
    game::set_value_at(game, factors[i].path, values[i]);
  game::check_game(game);
  return game;
}

SetByValues set_by_values(const game::GameSettings& base, const std::vector<Factor>& keys) {
  std::set<std::string> varied;
  for (const Factor& key : keys) varied.insert(game::full_path(key.path));
  SetByValues all;
  for (const Factor& key : keys) add(base, key, varied, all);
  return all;
}

}  // namespace autoref::experiments
