// Writes scenarios with every setting spelt out.
#include <fmt/format.h>

#include <algorithm>

#include "runner/experiments/cells.hpp"
#include "runner/experiments/reading/effective.hpp"
#include "runner/experiments/reading/factor_reader.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/experiments/situations_text.hpp"
#include "runner/experiments/sprt_settings.hpp"
#include "runner/experiments/tuning_settings.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"
#include "runner/io/yaml_bounds.hpp"
#include "runner/io/yaml_scalar.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

std::string comment_on(const Setting& setting) {
  return fmt::format("  # {}; {}", setting.about, expected_of(setting));
}

// Whether the setting is a non-empty list of players or types, whose own settings are listed too.
bool is_spelt_out(const Setting& setting) {
  if (const auto* players = std::get_if<Players*>(&setting.target)) return !(**players).empty();
  if (const auto* types = std::get_if<RobotTypes*>(&setting.target)) return !(**types).empty();
  return false;
}

// Writes settings as nested YAML, opening only the branches that differ from the previous
// setting's.
class Tree {
 public:
  explicit Tree(int depth) : depth_(depth) {}

  void add(const Setting& setting) {
    const std::size_t dot = setting.path.rfind('.');
    enter(dot == std::string::npos ? "" : setting.path.substr(0, dot));
    const std::string name = setting.path.substr(dot == std::string::npos ? 0 : dot + 1);
    if (holds_others(setting)) {
      line(branches_.size(), fmt::format("{}: {}", name, value_of(setting)));
    } else {
      line(branches_.size(), fmt::format("{}: {}{}", name, value_of(setting), comment_on(setting)));
    }
  }

  const std::string& text() const { return text_; }

 private:
  void enter(std::string_view path) {
    std::vector<std::string> wanted;
    while (!path.empty()) {
      const std::size_t dot = path.find('.');
      wanted.emplace_back(path.substr(0, dot));
      path = dot == std::string_view::npos ? "" : path.substr(dot + 1);
    }
    std::size_t same = 0;
    while (same < wanted.size() && same < branches_.size() && wanted[same] == branches_[same]) {
      ++same;
    }
    for (std::size_t i = same; i < wanted.size(); ++i) line(i, wanted[i] + ":");
    branches_ = std::move(wanted);
  }

  void line(std::size_t depth, const std::string& content) {
    text_ += fmt::format("{:{}}{}\n", "", 2 * (static_cast<std::size_t>(depth_) + depth), content);
  }

  int depth_;
  std::vector<std::string> branches_;
  std::string text_;
};

std::string body_of(const GameSettings& game) {
  GameSettings copy = game;
  Tree tree(0);
  for (const Setting& setting : settings_of(copy)) {
    if (!is_alias(setting) && !is_spelt_out(setting)) tree.add(setting);
  }
  return tree.text();
}

// Removes the robot overrides at these paths.
void leave_out_changes(const std::map<std::string, std::string>& values, GameSettings& game) {
  const std::vector<Setting> settings = settings_of(game);
  for (const auto& [path, value] : values) {
    const Setting* holder = find_setting(settings, branch_of(path));
    const auto* of = holder == nullptr ? nullptr : std::get_if<ChangesOf>(&holder->target);
    if (of != nullptr) of->changes->erase(of->branch + path.substr(holder->path.size()));
  }
}

bool is_among(const SetByValues& set_by_values, const std::string& path) {
  return std::any_of(set_by_values.begin(), set_by_values.end(),
                     [&path](const auto& value) { return value.second.contains(path); });
}

// Leaves out settings decided by the schedule or by varied values, and the branch `elsewhere`.
std::string base_of(const GameSettings& base, std::string_view elsewhere = "",
                    const SetByValues& set_by_values = {}) {
  GameSettings copy = base;
  for (const auto& [value, settings] : set_by_values) leave_out_changes(settings, copy);
  Tree tree(1);
  for (const Setting& setting : settings_of(copy)) {
    if (is_alias(setting) || is_spelt_out(setting) || is_decided_by_schedule(setting.path))
      continue;
    if (!elsewhere.empty() && setting.path.starts_with(elsewhere)) continue;
    if (is_among(set_by_values, setting.path)) continue;
    tree.add(setting);
  }
  return "base:\n" + tree.text();
}

std::string block_of(const SetByValues& set_by_values) {
  if (set_by_values.empty()) return "";
  std::string text = "set_by_values:  # settings implied by each value; written by AutoRef\n";
  for (const auto& [name, values] : set_by_values) {
    text += fmt::format("  {}:\n", quoted_scalar(name));
    for (const auto& [path, value] : values) text += fmt::format("    {}: {}\n", path, value);
  }
  return text;
}

std::string body_of(const Sweep& sweep) {
  const SetByValues by_values = set_by_values(sweep);
  std::string text = base_of(sweep.base, "", by_values) + "factors:\n";
  for (const Factor& factor : sweep.factors) {
    text += fmt::format("  {}: [{}]\n", factor.path, listed(spelt(factor.values)));
  }
  return text + block_of(by_values) + fmt::format("pairs: {}\nseed: {}\n", sweep.pairs, sweep.seed);
}

std::string seeds_of(const JudgeSchedule& schedule) {
  if (schedule.seeds.front().name.empty()) {
    return fmt::format("seed: {}\n", schedule.seeds.front().text);
  }
  std::string text = "seeds:\n";
  for (const NamedSeed& seed : schedule.seeds) {
    text += fmt::format("  {}: {}\n", seed.name, seed.text);
  }
  return text;
}

std::string body_of(const JudgeSchedule& schedule) {
  const SetByValues by_values = set_by_values(schedule);
  std::string text = base_of(schedule.base, "", by_values) +
                     fmt::format("rules: [{}]\ncameras: [{}]\n", listed(schedule.rules),
                                 listed(schedule.cameras)) +
                     block_of(by_values);
  std::vector<std::string> matchups;
  for (const auto& matchup : schedule.matchups) matchups.push_back(name_of(matchup));
  if (!matchups.empty()) text += fmt::format("matchups: [{}]\n", listed(matchups));
  if (!schedule.teams.empty()) text += fmt::format("teams: [{}]\n", listed(schedule.teams));
  return text + fmt::format("games: {}\n{}", schedule.games, seeds_of(schedule));
}

std::string block_of(const Teams& teams, std::string_view branch, const RobotTypes& types) {
  Tree tree(0);
  for (auto [name, team] : teams) {
    for (const Setting& setting : settings_of(team, types, fmt::format("{}.{}.", branch, name))) {
      if (!is_alias(setting) && !is_spelt_out(setting)) tree.add(setting);
    }
  }
  return tree.text();
}

std::string teams_of(const NamedTeams& named) {
  return base_of(named.base, "teams.") + block_of(named.teams, "teams", named.base.types);
}

std::string body_of(const RoundRobin& robin) {
  return teams_of(robin) + fmt::format("pairs: {}\nseed: {}\n", robin.pairs, robin.seed);
}

std::string body_of(const SprtMatch& match) {
  Tree tree(0);
  SequentialTest test = match.sprt;
  for (const Setting& setting : settings_of(test)) tree.add(setting);
  return teams_of(match) + tree.text() + fmt::format("seed: {}\n", match.seed);
}

std::string body_of(const Gauntlet& gauntlet) {
  return teams_of(gauntlet) + block_of(gauntlet.challengers, "challengers", gauntlet.base.types) +
         fmt::format("pairs: {}\nseed: {}\n", gauntlet.pairs, gauntlet.seed);
}

std::string body_of(const Knockout& knockout) {
  return teams_of(knockout) + fmt::format(
                                  "order: [{}]  # the best seed first\nthird_place: {}\n"
                                  "seed: {}\n",
                                  listed(knockout.order), knockout.third_place, knockout.seed);
}

std::string body_of(const Situations& situations) {
  const RobotTypes& types = situations.base.types;
  return base_of(situations.base, "teams.") + block_of(situations.attackers, "attackers", types) +
         block_of(situations.defenders, "defenders", types) + situations_text(situations) +
         fmt::format("pairs: {}\nseed: {}\n", situations.pairs, situations.seed);
}

void add(const std::vector<Setting>& settings, Tree& tree) {
  for (const Setting& setting : settings) {
    if (!is_alias(setting) && !is_spelt_out(setting)) tree.add(setting);
  }
}

std::string body_of(const Tuning& tuning) {
  Tuning copy = tuning;
  Tree tree(0);
  add(settings_of(copy.team, copy.base.types, "team."), tree);
  for (TunedParameter& parameter : copy.parameters) add(settings_of(parameter), tree);
  std::vector<Setting> settings = settings_of(copy);
  if (tuning.method != kSpsaName) {
    std::erase_if(settings, [](const Setting& setting) { return setting.path == "gain"; });
  }
  add(settings, tree);
  add(weight_settings_of(copy), tree);
  return base_of(tuning.base, "teams.") + tree.text() +
         (tuning.is_against_itself() ? "opponents: self\n"
                                     : block_of(tuning.opponents, "opponents", tuning.base.types)) +
         fmt::format("seed: {}\n", tuning.seed);
}

}  // namespace

std::string effective_text(const Scenario& scenario) {
  std::string text =
      fmt::format("schema: 1\nkind: {}\nabout: {}\n", kind_of(scenario),
                  quoted_scalar(scenario.about)) +
      std::visit([](const auto& content) { return body_of(content); }, scenario.content);
  if (text.size() <= YamlBounds{}.bytes) return text;
  throw InputError(
      {}, "",
      fmt::format("the scenario has {} bytes with every setting spelt out, but at most "
                  "{} can be read back; use fewer teams",
                  text.size(), YamlBounds{}.bytes));
}

}  // namespace autoref::runner
