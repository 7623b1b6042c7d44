#include "experiments/reading/factor_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "game/settings/fields.hpp"

namespace autoref::experiments {

bool is_decided_by_schedule(std::string_view path) {
  return path == "match.a_plays" || path == "match.first_kickoff" || path == "seed";
}

void refuse_decided(const game::YamlFile& file, const game::YamlLocation& location,
                    std::string_view path) {
  file.refuse(location, path, "set automatically for each game; leave it out here");
}

std::vector<Factor> FactorReader::read(const game::YamlEntry& factors, game::GameSettings& base) {
  const std::vector<game::YamlEntry> entries = file_.entries(factors, "factors", {});
  if (entries.empty())
    file_.refuse(factors.location, "factors",
                 "expected at least one factor, such as b.handicap: [1.0, 0.9]");
  std::vector<Factor> all;
  for (const game::YamlEntry& entry : entries) {
    if (is_decided_by_schedule(entry.key)) refuse_decided(file_, entry.location, entry.key);
    all.push_back(read_factor(entry, base));
    refuse_overlap(entry, all, base);
  }
  const std::vector<game::Setting> settings = game::settings_of(base);
  for (const Factor& factor : all) {
    const std::string path = game::full_path(factor.path);
    const game::Setting* setting = game::find_setting(settings, path);
    if (setting == nullptr) setting = game::preset_of_branch(settings, path);
    if (setting != nullptr && game::is_preset(*setting))
      game::set_value_at(base, factor.path, factor.values.front());
  }
  return all;
}

Factor FactorReader::read_factor(const game::YamlEntry& entry, game::GameSettings& base) {
  locations_[game::full_path(entry.key)] = entry.location;
  return {game::short_path(entry.key), values(entry, entry.key, base)};
}

std::vector<game::SettingValue> FactorReader::values(const game::YamlEntry& list,
                                                     const std::string& path,
                                                     game::GameSettings& base) const {
  std::vector<game::SettingValue> values;
  if (!list.value.IsSequence() || list.value.size() == 0) {
    file_.refuse(game::value_location(list), list.key,
                 "expected a non-empty list of values, such as [1.0, 0.9]");
  }
  for (const YAML::Node& node : list.value) {
    const game::YamlLocation location = game::location_of(node);
    if (!node.IsScalar())
      file_.refuse(location, list.key, "expected plain values, such as [1.0, 0.9]");
    game::SettingValue read = value(location, path, node.Scalar(), base);
    if (std::find(values.begin(), values.end(), read) != values.end()) {
      file_.refuse(location, list.key,
                   fmt::format("the value {} is given twice; leave one out", game::spelt(read)));
    }
    values.push_back(std::move(read));
  }
  return values;
}

game::SettingValue FactorReader::value(const game::YamlLocation& location, const std::string& path,
                                       const std::string& text, game::GameSettings& base) const {
  game::GameSettings game = base;
  game::SettingValue value;
  try {
    value = game::set_by_path(game, path, text, file_.folder());
  } catch (const std::invalid_argument& error) {
    file_.refuse(location, path, error.what());
  }
  base.types.merge(game.types);
  base.measured_balls.merge(game.measured_balls);
  base.measured_cameras.merge(game.measured_cameras);
  return value;
}

void FactorReader::refuse_overlap(const game::YamlEntry& entry, const std::vector<Factor>& factors,
                                  const game::GameSettings& base) const {
  const std::string& last = factors.back().path;
  const auto refuse = [&](const std::string& other) {
    file_.refuse(entry.location, entry.key,
                 fmt::format("'{}' sets the same value; leave one out", other));
  };
  for (std::size_t i = 0; i + 1 < factors.size(); ++i) {
    const std::string& other = factors[i].path;
    if (game::sets_same_number(last, other)) refuse(other);
  }
  for (const std::string& given : base.given) {
    if (last.ends_with(".handicap") && game::sets_same_number(game::full_path(last), given)) {
      refuse("base." + given);
    }
  }
}

}  // namespace autoref::experiments
