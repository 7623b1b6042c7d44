// The reference pages of scenario files, with the keys of each kind, and of settings, with every
// key of a game and what each preset sets.
#include <fmt/format.h>
#include <algorithm>
#include <map>

#include "app/description/reference_pages.hpp"
#include "experiments/kinds/all_kinds.hpp"
#include "experiments/kinds/scenario.hpp"
#include "game/settings/fields.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::app {
namespace {

constexpr const char* kAboutFiles =
    "All keys of each kind of scenario. Every file also has `schema: 1` and its `kind`, and can "
    "have `about`, a sentence that reports show. The keys of `teams`, `match`, `field`, `sim` and "
    "`base` are [settings](settings.md); [scenarios](../scenarios.md) and "
    "[experiments](../experiments.md) explain them with examples. Robot types, measured presets "
    "and lab scenes have [their own files](other-files.md).\n\n";

const std::vector<experiments::KeyRow> kGameRows = {
    {"`types`", "robot types by name", "types that `type` can name instead of a file"},
    {"`measured`", "`ball` and `camera`",
     "presets by name, which `sim.ball` and `sim.camera` can name instead of a file"},
    {"`teams`", "`a` and `b`", "the two teams"},
    {"`match`", "settings", "rule book, halves, who commands"},
    {"`field`", "settings", "sizes of the field"},
    {"`sim`", "settings", "world, robots, cameras"},
    {"`seed`", "whole number; 42", "random seed of the game"}};

std::string section(const std::string& title, std::string_view about,
                    const std::vector<experiments::KeyRow>& keys) {
  std::vector<std::vector<std::string>> rows = {{"name", "value", "meaning"}};
  for (const experiments::KeyRow& key : keys) rows.push_back({key.names, key.value, key.about});
  return fmt::format("## {}\n\n{}{}{}", title, about, about.empty() ? "" : "\n\n",
                     reference_table(rows));
}

// A link to a section of this page; anchors contain no colon.
std::string link_to(const std::string& title) {
  std::string anchor;
  for (const char c : title) {
    if (c != ':') anchor += c == ' ' ? '-' : c;
  }
  return fmt::format("see [below](#{})", anchor);
}

std::string sections_of(const experiments::Kind& kind) {
  const std::unique_ptr<experiments::Experiment> experiment = kind.make();
  std::vector<experiments::KeyRow> rows;
  std::string below;
  for (const experiments::Key& key : experiment->keys()) {
    if (!key.below) {
      rows.push_back({code_span(key.name), key.value, key.about});
      continue;
    }
    const experiments::KeysBelow inner = key.below();
    const std::string title = fmt::format("{}: {}", kind.name, inner.title);
    rows.push_back({code_span(key.name), link_to(title), key.about});
    below += section(title, inner.about, inner.rows);
  }
  return section(std::string(kind.name), kind.about, rows) + below;
}

using Rows = std::vector<std::vector<std::string>>;

constexpr const char* kIntroduction =
    "Every key of a game. You can use them in a scenario's sections, after `--set`, and as factors "
    "of a sweep. `a.` and `b.` stand for `teams.a.` and `teams.b.`: `--set b.robots=5`. Defaults "
    "are those of the rule book `paper`; `[]` is an empty list of words. "
    "[scenarios.md](../scenarios.md) explains the sections and the keys of experiments.\n\n";

// Any one robot can represent all of a team's robots.
constexpr int kAnyPlayer = 3;

// "teams.a.players.3.type" as shown on the page: "teams.a.players.N.type".
std::string shown_path(std::string path) {
  const std::string numbered = fmt::format(".players.{}", kAnyPlayer);
  const std::size_t found = path.find(numbered);
  return found == std::string::npos ? path : path.replace(found, numbered.size(), ".players.N");
}

std::string shown_default(const game::Setting& setting) {
  const std::string value = game::value_of(setting);
  return value.empty() || value == "\"\"" || value == "''" ? "" : code_span(value);
}

std::vector<std::string> row_of(const game::Setting& setting) {
  const std::string path = shown_path(setting.path);
  const std::size_t dot = path.rfind('.');
  return {code_span(dot == std::string::npos ? path : path.substr(dot + 1)), shown_default(setting),
          game::expected_of(setting), std::string(setting.about)};
}

// The branches in the order of the settings, each with its rows of the table.
std::vector<std::pair<std::string, Rows>> branches_of(const std::vector<game::Setting>& settings) {
  std::vector<std::pair<std::string, Rows>> branches;
  for (const game::Setting& setting : settings) {
    if (setting.path.starts_with("teams.b.")) continue;  // described as settings of team a
    if (setting.path.starts_with(kRuleNumberBranch)) continue;
    const std::string path = shown_path(setting.path);
    const std::string branch(path.find('.') == std::string::npos ? "" : game::branch_of(path));
    auto found = std::find_if(branches.begin(), branches.end(),
                              [&](const auto& known) { return known.first == branch; });
    if (found == branches.end()) {
      branches.push_back({branch, {{"key", "default", "value", "meaning"}}});
      found = std::prev(branches.end());
    }
    found->second.push_back(row_of(setting));
  }
  return branches;
}

std::string heading_of(const std::string& branch) {
  if (branch.empty()) return "Top level";
  if (branch == "teams.a") return "`teams.a`, `teams.b`";
  return code_span(branch);
}

// The values of all settings when the preset at `path` is `word`, in the order of settings_of().
std::vector<std::string> values_with(const std::string& path, const std::string& word) {
  game::GameSettings game;
  game::set_by_path(game, path, word);
  std::vector<std::string> values;
  for (const game::Setting& setting : game::settings_of(game))
    values.push_back(game::value_of(setting));
  return values;
}

// The page of rules has their values in each rule book.
bool is_on_rules_page(const game::Setting& setting) {
  return setting.path.starts_with(kRuleSwitchBranch) || setting.path.starts_with(kRuleNumberBranch);
}

bool is_shown_for_presets(const game::Setting& setting) {
  return !game::is_preset(setting) && !setting.path.starts_with("teams.b.") &&
         !is_on_rules_page(setting);
}

// A table with a row for each key that depends on the preset and a column for each preset.
std::string preset_section(const std::string& path) {
  game::GameSettings game;
  const std::vector<game::Setting> settings = game::settings_of(game);
  const std::vector<std::string> words = game::find_setting(settings, path)->allowed_words;
  Rows rows = {{"key"}};
  std::vector<std::vector<std::string>> values;
  for (const std::string& word : words) {
    rows.front().push_back(code_span(word));
    values.push_back(values_with(path, word));
  }
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (!is_shown_for_presets(settings[i])) continue;
    std::vector<std::string> row = {code_span(game::short_path(settings[i].path))};
    for (const auto& of_word : values) row.push_back(of_word[i]);
    const bool differs = std::any_of(row.begin() + 1, row.end(),
                                     [&row](const std::string& cell) { return cell != row[1]; });
    if (differs) rows.push_back(std::move(row));
  }
  return fmt::format("## What `{}` sets\n\n", path) + reference_table(rows);
}

}  // namespace

std::string scenario_files_page() {
  std::string page =
      reference_head("Keys of scenario files", "scenario-files") + kAboutFiles +
      section(std::string(experiments::kGameKind), "One game, for `play` and `live`.", kGameRows);
  for (const experiments::Kind* kind : experiments::kinds_of_experiments())
    page += sections_of(*kind);
  page.pop_back();
  return page;
}

std::string settings_page() {
  game::GameSettings game;
  game::player_of(game.a.players, std::to_string(kAnyPlayer));
  std::string page = reference_head("Settings", "settings") + kIntroduction;
  for (const auto& [branch, rows] : branches_of(game::settings_of(game))) {
    page += fmt::format("## {}\n\n", heading_of(branch)) + reference_table(rows);
  }
  page +=
      "The page [Rules](rules.md) lists the rules in force in each rule book, and all keys of "
      "`match.rule`, the numbers of the rule book.\n\n";
  for (const char* preset :
       {"match.rules", "sim.camera", "sim.ball.preset", "sim.kicker.preset", "sim.dribbler.preset"})
    page += preset_section(preset);
  page.pop_back();
  return page;
}

}  // namespace autoref::app
