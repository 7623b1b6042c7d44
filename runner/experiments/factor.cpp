#include "runner/experiments/factor.hpp"

#include <set>

#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

struct AsNumber {
  std::optional<double> operator()(const std::string& /*word*/) const { return std::nullopt; }
  std::optional<double> operator()(auto number) const { return static_cast<double>(number); }
};

using SpeltValues = std::map<std::string, std::string>;  // values by full path

// Adds the overrides of some robots to `values`, by full path.
void add(const ChangesOf& of, const std::string& holder, SpeltValues& values) {
  for (const auto& [path, value] : *of.changes) {
    if (branch_of(path) != of.branch) continue;
    values[holder + path.substr(of.branch.size())] = spelt(value);
  }
}

SpeltValues values_in(GameSettings game) {
  SpeltValues values;
  for (const Setting& setting : settings_of(game)) {
    if (const auto* of = std::get_if<ChangesOf>(&setting.target)) add(*of, setting.path, values);
    if (!is_alias(setting) && !holds_others(setting)) values[setting.path] = value_of(setting);
  }
  return values;
}

// Adds the settings implied by each value of one key, except keys in `varied` and settings given in
// the base.
void add(const GameSettings& base, const Factor& key, const std::set<std::string>& varied,
         SetByValues& all) {
  const SpeltValues of_base = values_in(base);
  std::map<std::string, SpeltValues> found;
  // A path that one value changes is listed for every value, so that the columns are complete.
  std::set<std::string> paths;
  for (const SettingValue& value : key.values) {
    GameSettings game = base;
    set_value_at(game, key.path, value);
    SpeltValues& its = found[key.path + "=" + spelt(value)] = values_in(game);
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
  for (const SettingValue& value : factor.values) {
    const std::optional<double> number = std::visit(AsNumber{}, value);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<std::vector<SettingValue>> combinations(const std::vector<Factor>& factors) {
  std::vector<std::vector<SettingValue>> all = {{}};
  for (const Factor& factor : factors) {
    // Cartesian product, built up one factor at a time.
    std::vector<std::vector<SettingValue>> longer;
    for (const std::vector<SettingValue>& start : all) {
      for (const SettingValue& value : factor.values) {
        longer.push_back(start);
        longer.back().push_back(value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

GameSettings configured(const GameSettings& base, const std::vector<Factor>& factors,
                        const std::vector<SettingValue>& values) {
  GameSettings game = base;
  for (std::size_t i = 0; i < values.size(); ++i) set_value_at(game, factors[i].path, values[i]);
  check_game(game);
  return game;
}

SetByValues set_by_values(const GameSettings& base, const std::vector<Factor>& keys) {
  std::set<std::string> varied;
  for (const Factor& key : keys) varied.insert(full_path(key.path));
  SetByValues all;
  for (const Factor& key : keys) add(base, key, varied, all);
  return all;
}

}  // namespace autoref::runner
