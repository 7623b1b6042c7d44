#include <fmt/format.h>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/reading/factor_reader.hpp"
#include "experiments/report/sections.hpp"
#include "experiments/results/game_row.hpp"
#include "game/settings/fields.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::experiments {
namespace {

// Settings of an experiment that differ from the defaults.
struct DefaultDifference {
  std::string path;  // such as "match.half_s"
  std::string here;
  std::string by_default;
};

constexpr const char* kNothing = "{}";  // the value of a branch without changes

TextByPath comparable_values(const std::vector<game::Setting>& settings) {
  TextByPath values;
  for (const game::Setting& setting : settings) {
    if (!game::is_alias(setting) && !is_decided_by_schedule(setting.path) &&
        !setting.path.starts_with(game::kMeasuredBranch)) {
      values[setting.path] = game::value_of(setting);
    }
  }
  return values;
}

void compare(const TextByPath& here, const TextByPath& defaults,
             std::vector<DefaultDifference>& found) {
  for (const auto& [path, value] : here) {
    const auto usual = defaults.find(path);
    const std::string by_default = usual == defaults.end() ? kNothing : usual->second;
    if (value != by_default) found.push_back({game::short_path(path), value, by_default});
  }
}

TextByPath defaults_for(const game::GameSettings& game) {
  game::GameSettings usual;
  // The rule book also sets other values; only deviations from its values are of interest.
  game::set_by_path(usual, kRuleBookPath, game.match.rules.name);
  TextByPath values = comparable_values(game::settings_of(usual));
  values[kRuleBookPath] = referee::Match{}.rules.name;
  return values;
}

void compare_games(game::GameSettings game, bool has_named_teams,
                   std::vector<DefaultDifference>& found) {
  TextByPath here = comparable_values(game::settings_of(game));
  if (has_named_teams) {
    std::erase_if(here, [](const auto& value) { return value.first.starts_with("teams."); });
  }
  compare(here, defaults_for(game), found);
}

void compare_team(const game::GameSettings& base, const TeamAt& at,
                  std::vector<DefaultDifference>& found) {
  game::GameSettings usual;
  game::set_by_path(usual, kRuleBookPath, base.match.rules.name);
  const std::string prefix = at.path + ".";
  compare(comparable_values(game::settings_of(*at.team, base.types, prefix)),
          comparable_values(game::settings_of(usual.a, usual.types, prefix)), found);
}

void compare_key(const Key& key, const game::GameSettings& base,
                 std::vector<DefaultDifference>& found) {
  if (key.base != nullptr) return compare_games(base, !key.teams, found);
  if (!key.teams) return;
  for (const TeamAt& at : key.teams()) compare_team(base, at, found);
}

// A setting has no single value if a factor varies it or a varied preset sets it.
void leave_out_factors(const game::GameSettings& base, const std::vector<Factor>& factors,
                       std::vector<DefaultDifference>& found) {
  for (const auto& [value, settings] : set_by_values(base, factors)) {
    std::erase_if(found, [&settings = settings](const auto& difference) {
      return settings.contains(game::full_path(difference.path));
    });
  }
  for (const Factor& factor : factors) {
    std::erase_if(found, [&](const auto& difference) { return difference.path == factor.path; });
  }
}

const game::GameSettings& base_of(const std::vector<Key>& keys) {
  for (const Key& key : keys) {
    if (key.base != nullptr) return *key.base;
  }
  throw std::logic_error("an experiment without a key for its base");
}

// Differences in the settings common to all games and in those of each named team, from the
// defaults of the experiment's rule book. Excludes settings determined by factors or the schedule.
std::vector<DefaultDifference> differences_from_defaults(const Experiment& experiment) {
  const std::unique_ptr<Experiment> copy = experiment.copy();
  const std::vector<Key> keys = copy->keys();
  const game::GameSettings& base = base_of(keys);
  std::vector<DefaultDifference> found;
  for (const Key& key : keys) compare_key(key, base, found);
  leave_out_factors(base, copy->varied_settings(), found);
  return found;
}

constexpr std::size_t kMostVoidGames = 20;  // maximum number listed one by one

std::string effective_file(const std::string& direction) {
  return direction == "." ? kEffectiveFile : fmt::format("{}/{}", direction, kEffectiveFile);
}

}  // namespace

Section void_section(const ResultFolder& folder) {
  List list;
  std::size_t others = 0;
  for (const auto& [id, row] : folder.completed_games.done) {
    if (!is_void(row.record)) continue;
    if (list.items.size() == kMostVoidGames) {
      ++others;
    } else {
      list.items.push_back(fmt::format("{}: {}", id, row.record.void_reason));
    }
  }
  if (list.items.empty()) return {};
  if (others > 0) list.items.push_back(fmt::format("and {} more, in results.csv", others));
  return {
      Heading{"Void games"},
      Paragraph{"Void games do not count in means or intervals; the other leg of their pair counts "
                "in means, but not in intervals."},
      list};
}

Section settings_section(const ResultFolder& folder, const std::string& direction) {
  const std::vector<DefaultDifference> differences =
      differences_from_defaults(folder.scenario.experiment());
  Table table{{{"setting", "value", "default"}}, 3};
  for (const DefaultDifference& difference : differences) {
    table.rows.push_back({difference.path, difference.here, difference.by_default});
  }
  Section section = {Heading{"Settings"}, Link{effective_file(direction), "All settings"}};
  if (!differences.empty()) {
    const Paragraph intro{"Differences from the defaults of the rule book:"};
    section.emplace_back(intro);
    section.emplace_back(table);
  }
  return section;
}

Section commands_section(const ResultFolder& folder, const std::string& direction) {
  const std::string folder_and_build =
      direction + (folder.completed_games.other_builds.empty() ? "" : " --build " + folder.build);
  return {
      Heading{"How to reproduce"},
      Paragraph{
          fmt::format("Run these in the folder of this report, with build {}, to play all games "
                      "again, to replay five and compare them, and to write the report again:",
                      folder.build)},
      Verbatim{fmt::format("autoref {2} {0} -o again\n"
                           "autoref results verify {1} --sample 5\n"
                           "autoref report {1}\n",
                           effective_file(direction), folder_and_build, verb_of(folder.scenario))}};
}

}  // namespace autoref::experiments
