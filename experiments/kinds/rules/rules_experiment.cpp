#include "experiments/kinds/rules/rules_experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/kinds/rules/rules_report.hpp"
#include "experiments/reading/factor_reader.hpp"
#include "experiments/reading/named_teams_reader.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/schedule/schedule.hpp"
#include "game/settings/fields.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kVariants = "variants";

std::string variant_path(const std::string& name) { return fmt::format("{}.{}", kVariants, name); }

bool is_of_the_rules(const std::string& path) {
  const std::string full = game::full_path(path);
  return full.starts_with("match.") || full.starts_with("field.") || full == "teams.a.robots" ||
         full == "teams.b.robots";
}

// Reads one variant, and refuses what is not part of the rules or given twice.
class RuleVariantReader {
 public:
  RuleVariantReader(TopReader& top, game::GameSettings& base) : top_(top), base_(base) {}

  RuleVariant read(const game::YamlEntry& entry) {
    const game::YamlFile& file = top_.file();
    check_name(file, entry, kVariants, "variant");
    const std::string path = variant_path(entry.key);
    top_.locations()[path] = entry.location;
    RuleVariant variant{entry.key, {}};
    for (const game::YamlEntry& setting : file.entries(entry, path, {})) {
      if (is_decided_by_schedule(setting.key)) refuse_decided(file, setting.location, setting.key);
      const std::string its_path = game::short_path(setting.key);
      if (variant.settings.contains(its_path))
        file.refuse(setting.location, setting.key, "given twice; leave one out");
      variant.settings[its_path] = value_of(setting);
      top_.locations()[fmt::format("{}.{}", path, game::full_path(its_path))] = setting.location;
    }
    return variant;
  }

 private:
  game::SettingValue value_of(const game::YamlEntry& setting) {
    const std::string text =
        top_.file().scalar(setting, setting.key, "a plain value, such as 0.15", false);
    game::SettingValue value = FactorReader(top_.file(), top_.locations())
                                   .value(game::value_location(setting), setting.key, text, base_);
    if (!is_of_the_rules(setting.key))
      top_.file().refuse(setting.location, setting.key,
                         "a variant can only set match, field, a.robots and b.robots; put "
                         "everything else into base or teams");
    top_.refuse_assignment(setting.key);
    return value;
  }

  TopReader& top_;
  game::GameSettings& base_;
};

void refuse_equal_variants(const game::YamlFile& file, const game::YamlEntry& last,
                           const std::vector<RuleVariant>& variants) {
  for (std::size_t i = 0; i + 1 < variants.size(); ++i) {
    if (variants[i].settings == variants.back().settings)
      file.refuse(last.location, variant_path(last.key),
                  fmt::format("has the same settings as '{}'; leave one out", variants[i].name));
  }
}

// Settings that differ from the base's rule book, such as those of a preset, keep their values
// under the variants' rule books.
void keep_settings_of_base(game::GameSettings& base) {
  game::GameSettings official;
  game::choose_rules(base.match.rules.name, official);
  const TextByPath usual = values_of(game::settings_of(official));
  for (const auto& [path, value] : values_of(game::settings_of(base))) {
    const auto found = usual.find(path);
    if (path != kRuleBookPath && found != usual.end() && found->second != value)
      base.given.insert(path);
  }
}

void read_rule_variants(TopReader& top, RulesExperiment& rules) {
  const game::YamlEntry& list = top.required(kVariants);
  RuleVariantReader reader(top, rules.base);
  for (const game::YamlEntry& entry : top.file().entries(list, kVariants, {})) {
    rules.variants.push_back(reader.read(entry));
    refuse_equal_variants(top.file(), entry, rules.variants);
  }
  if (rules.variants.size() < 2)
    top.file().refuse(list.location, kVariants,
                      "expected at least two variants, such as official: {} and "
                      "longer: { match.rule.dribbling_m: 2 }");
  const auto has_book = [](const RuleVariant& v) { return v.settings.contains(kRuleBookPath); };
  if (std::none_of(rules.variants.begin(), rules.variants.end(), has_book)) return;
  keep_settings_of_base(rules.base);
  for (RuleVariant& variant : rules.variants)
    variant.settings.emplace(kRuleBookPath, rules.base.match.rules.name);
}

Key rule_variants_key(RulesExperiment& rules) {
  Key key{kVariants, "settings by name",
          "the rules to compare, such as `longer: { match.rule.dribbling_m: 2 }`: settings of "
          "`match` and `field`, `a.robots` and `b.robots`. The others are compared with the first, "
          "which is usually `official: {}`"};
  key.read = [&rules](TopReader& top) { read_rule_variants(top, rules); };
  key.text = [&rules] {
    std::string text = fmt::format("{}:\n", kVariants);
    for (const RuleVariant& variant : rules.variants) {
      text += fmt::format("  {}:{}\n", variant.name, variant.settings.empty() ? " {}" : "");
      for (const auto& [path, value] : variant.settings)
        text += fmt::format("    {}: {}\n", path, game::spelt(value));
    }
    return text;
  };
  key.values = [&rules] {
    TextByPath values;
    for (const RuleVariant& variant : rules.variants)
      for (const auto& [path, value] : variant.settings)
        values[fmt::format("{}.{}", variant_path(variant.name), path)] = game::spelt(value);
    return values;
  };
  key.entries = [&rules] {
    std::vector<std::string> names;
    for (const RuleVariant& variant : rules.variants) names.push_back(variant.name);
    return names;
  };
  return key;
}

// The games of a variant: their common settings, and each team as a and as b.
struct VariantSettings {
  SharedSettings game;
  std::map<std::string, std::shared_ptr<const game::TeamSettings>> as_a;
  std::map<std::string, std::shared_ptr<const game::TeamSettings>> as_b;
};

// The error with the path of the variant's setting, or of the variant if it does not set it: two
// numbers can contradict each other.
game::SettingError in_variant(const game::SettingError& error, const RuleVariant& variant) {
  const std::string path = variant_path(variant.name);
  if (variant.settings.contains(game::short_path(error.path()))) return error.below(path);
  return {path, fmt::format(".{}", error.what())};
}

// The team against itself under the variant. It keeps its number of robots under every rule book,
// unless that is the official number of the base's rule book.
game::GameSettings game_of(const RulesExperiment& rules, const RuleVariant& variant,
                           const game::TeamSettings& team) {
  game::GameSettings game = rules.base;
  game.a = game.b = team;
  if (team.robots != rules.base.a.robots) game.given.insert({"teams.a.robots", "teams.b.robots"});
  try {
    for (const auto& [path, value] : variant.settings) game::set_value_at(game, path, value);
    game::check_game(game);
    refuse_game_controller(game);
  } catch (const game::SettingError& error) {
    throw in_variant(error, variant);
  }
  return game;
}

VariantSettings settings_of(const RulesExperiment& rules, const RuleVariant& variant) {
  VariantSettings its{SharedSettings(game_of(rules, variant, rules.teams.begin()->second)), {}, {}};
  for (const auto& [name, team] : rules.teams) {
    const game::GameSettings game = game_of(rules, variant, team);
    its.as_a[name] = std::make_shared<const game::TeamSettings>(game.a);
    its.as_b[name] = std::make_shared<const game::TeamSettings>(game.b);
  }
  return its;
}

ScheduledGame scheduled(const RulesExperiment& rules, const RuleVariant& variant,
                        const VariantSettings& its, const Matchup& matchup, int pair, int leg) {
  const SharedSettings settings =
      its.game.between(its.as_a.at(matchup.team_a), its.as_b.at(matchup.team_b));
  return {game_id(fmt::format("{}+{}", variant.name, matchup_name(matchup)), pair, leg),
          {variant.name},
          pair,
          leg,
          settings.with(leg_of(rules.seed, pair, leg)),
          matchup.team_a,
          matchup.team_b};
}

}  // namespace

constinit const Kind RulesExperiment::kKind = {
    "rules",
    "Every team against every other under several variants of the rules; see "
    "[rule-laboratory](../rule-laboratory.md).",
    make};

std::vector<Key> RulesExperiment::keys() {
  const auto varied_now = [this] { return varied_settings(); };
  return {base_key(*this, varied_now),
          teams_key(*this, "each with any setting that a team can have"),
          rule_variants_key(*this),
          set_by_values_key(base, varied_now),
          pairs_key(pairs, "pairs of legs per variant and matchup"),
          seed_key(seed)};
}

std::vector<Factor> RulesExperiment::varied_settings() const {
  std::map<std::string, Factor> factors;
  for (const RuleVariant& variant : variants) {
    for (const auto& [path, value] : variant.settings) {
      Factor& factor = factors[path];
      factor.path = path;
      std::vector<game::SettingValue>& values = factor.values;
      if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
    }
  }
  std::vector<Factor> all;
  all.reserve(factors.size());
  for (auto& [path, factor] : factors) all.push_back(std::move(factor));
  return all;
}

std::vector<ScheduledGame> RulesExperiment::games() const {
  const std::vector<Matchup> matchups = matchups_among(teams);
  refuse_too_many(2.0 * pairs * static_cast<double>(variants.size()) *
                  static_cast<double>(matchups.size()));
  check(base, teams);
  std::vector<VariantSettings> settings;
  settings.reserve(variants.size());
  for (const RuleVariant& variant : variants) settings.push_back(settings_of(*this, variant));
  const std::vector<std::size_t> order = combinations_order({variants.size(), matchups.size()});
  return games_in_turns(order, pairs, [&](std::size_t i, int pair, int leg) {
    const std::size_t variant = i / matchups.size();
    return scheduled(*this, variants[variant], settings[variant], matchups[i % matchups.size()],
                     pair, leg);
  });
}

ExperimentResults RulesExperiment::results(const RowsById& rows) const {
  const RuleEffects effects = rule_effects_of(*this, rows);
  ExperimentResults results;
  results.files = {{"summary.csv", "a row per measure and variant", csv_of(effects)}};
  results.table = table_of(effects);
  results.shown = {progress_table_of(effects)};
  results.json = std::make_shared<io::Json>(io::Json{{"measures", json_of(effects)}});
  return results;
}

}  // namespace autoref::experiments
