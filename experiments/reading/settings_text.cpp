#include "experiments/reading/settings_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "experiments/reading/factor_reader.hpp"

namespace autoref::experiments {
namespace {

std::string comment_on(const game::Setting& setting) {
  return fmt::format("  # {}; {}", setting.about, game::expected_of(setting));
}

// Whether the setting is a non-empty list of players, types or presets; the settings of these are
// listed as well.
bool is_spelt_out(const game::Setting& setting) {
  if (const auto* players = std::get_if<game::Players*>(&setting.target))
    return !(**players).empty();
  if (const auto* types = std::get_if<game::RobotTypes*>(&setting.target))
    return !(**types).empty();
  if (const auto* presets = std::get_if<game::MeasuredPresets*>(&setting.target))
    return !(**presets).empty();
  return false;
}

// Writes settings as nested YAML, opening only the branches that differ from the previous
// setting's.
class Tree {
 public:
  explicit Tree(int depth) : depth_(depth) {}

  void add(const game::Setting& setting) {
    const std::size_t dot = setting.path.rfind('.');
    enter(dot == std::string::npos ? "" : setting.path.substr(0, dot));
    const std::string name = setting.path.substr(dot == std::string::npos ? 0 : dot + 1);
    if (game::holds_others(setting)) {
      line(branches_.size(), fmt::format("{}: {}", name, game::value_of(setting)));
    } else {
      line(branches_.size(),
           fmt::format("{}: {}{}", name, game::value_of(setting), comment_on(setting)));
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

void add(const std::vector<game::Setting>& settings, Tree& tree) {
  for (const game::Setting& setting : settings) {
    if (!game::is_alias(setting) && !is_spelt_out(setting)) tree.add(setting);
  }
}

// Removes the robot overrides at these paths.
void leave_out_changes(const std::map<std::string, std::string>& values, game::GameSettings& game) {
  const std::vector<game::Setting> settings = game::settings_of(game);
  for (const auto& [path, value] : values) {
    const game::Setting* holder = game::find_setting(settings, game::branch_of(path));
    const auto* of = holder == nullptr ? nullptr : std::get_if<game::ChangesOf>(&holder->target);
    if (of != nullptr) of->changes->erase(of->branch + path.substr(holder->path.size()));
  }
}

bool is_among(const SetByValues& set_by_values, const std::string& path) {
  return std::any_of(set_by_values.begin(), set_by_values.end(),
                     [&path](const auto& value) { return value.second.contains(path); });
}

}  // namespace

std::string text_of(const std::vector<game::Setting>& settings, int depth) {
  Tree tree(depth);
  add(settings, tree);
  return tree.text();
}

std::string base_text(const game::GameSettings& base, std::string_view elsewhere,
                      const SetByValues& set_by_values) {
  game::GameSettings copy = base;
  for (const auto& [value, settings] : set_by_values) leave_out_changes(settings, copy);
  std::vector<game::Setting> settings = game::settings_of(copy);
  std::erase_if(settings, [&](const game::Setting& setting) {
    return is_decided_by_schedule(setting.path) ||
           (!elsewhere.empty() && setting.path.starts_with(elsewhere)) ||
           is_among(set_by_values, setting.path);
  });
  return "base:\n" + text_of(settings, 1);
}

std::string teams_text(const Teams& teams, std::string_view branch, const game::RobotTypes& types,
                       const MoreTeamSettings& more) {
  Tree tree(0);
  for (auto [name, team] : teams) {
    const std::string prefix = fmt::format("{}.{}.", branch, name);
    add(game::settings_of(team, types, prefix), tree);
    if (more) add(more(name, prefix), tree);
  }
  return tree.text();
}

}  // namespace autoref::experiments
