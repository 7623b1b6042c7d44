#include "game/settings/fields.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>

#include "game/settings/mapping.hpp"
#include "sim/presets.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/rules/rule_changes.hpp"
#include "strategies/registry.hpp"

namespace autoref::game {
namespace {

std::vector<std::string> strategy_names() {
  std::vector<std::string> names;
  for (const strategies::Entry& entry : strategies::all_strategies()) {
    names.emplace_back(entry.name);
  }
  names.emplace_back(kNetworkStrategy);
  return names;
}

// Words for the laws that a team obeys: the league's rule books, and a word for none of them.
std::vector<std::string> laws_names() {
  std::vector<std::string> names = rule_book_names();
  std::erase_if(names, [](const std::string& name) {
    return find_rule_book(name)->edition == Edition::kPaper;
  });
  names.emplace_back(kEnforcedOnly);
  return names;
}

void list_changes(RobotChanges& changes, Branch to) {
  to.add("robot", ChangesOf{&changes, "robot"}, {}, "overrides of sim.robot");
  to.add("kicker", ChangesOf{&changes, "kicker"}, {}, "overrides of sim.kicker");
  to.add("dribbler", ChangesOf{&changes, "dribbler"}, {}, "overrides of sim.dribbler");
}

// Settings that all robots of a team and a single robot have in common.
template <typename Of>
void list_robots(Of& of, const RobotTypes& types, Branch to) {
  to.add("type", TypeName{&of.type, &types}, {}, "robot type");
  to.parameter(of.speed_factor,
               {"speed_factor", sim::kFactorRange, "scales the robots' top speed"});
  to.parameter(of.acceleration_factor, {"acceleration_factor", sim::kFactorRange,
                                        "scales the robots' acceleration and braking"});
  to.add("handicap", BothFactors{&of.speed_factor, &of.acceleration_factor}, sim::kFactorRange,
         "sets speed_factor and acceleration_factor");
  list_changes(of.changes, to);
}

void list_types(RobotTypes& types, Branch to) {
  to.add("types", &types, {}, "robot types by name");
  for (auto& [name, changes] : types) list_changes(changes, to.below("types").below(name));
}

void append(std::vector<Setting> from, std::vector<Setting>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

void list_measured(GameSettings& game, std::vector<Setting>& list) {
  Branch to(list, std::string(kMeasuredBranch));
  to.add("ball", &game.measured_balls, {}, "presets that sim.ball can name");
  for (auto& [name, preset] : game.measured_balls)
    append(ball_settings(preset.sim, fmt::format("{}ball.{}.", kMeasuredBranch, name)), list);
  to.add("camera", &game.measured_cameras, {}, "presets that sim.camera can name");
  for (auto& [name, preset] : game.measured_cameras)
    append(camera_settings(preset.sim, fmt::format("{}camera.{}.", kMeasuredBranch, name)), list);
}

// The settings of `sim` that have one of these paths or are below it.
std::vector<Setting> settings_at(const std::vector<std::string_view>& paths,
                                 sim::Configuration& sim, const std::string& prefix) {
  std::vector<Setting> settings;
  Branch(settings, "").parameters(sim);
  std::erase_if(settings, [&paths](const Setting& setting) {
    return std::none_of(paths.begin(), paths.end(), [&setting](std::string_view path) {
      return setting.path == path || setting.path.starts_with(fmt::format("{}.", path));
    });
  });
  for (Setting& setting : settings) setting.path.insert(0, prefix);
  return settings;
}

void list_team(TeamSettings& team, const RobotTypes& types, Branch to) {
  to.word("strategy", &team.strategy, strategy_names(), "the team's strategy");
  to.word(
      "laws", &team.laws, laws_names(),
      "the laws that the team knows: it obeys the rules in force, and also these if they are not "
      "in force; enforced: it obeys only the rules in force");
  to.add("command", CommandWords{&team.program.command}, {},
         "program that plays as the team, instead of a strategy");
  to.add("directory", FreeText{&team.program.directory}, {}, "working directory of the program");
  to.add("environment", CommandWords{&team.program.environment}, {},
         "environment variables of the program, such as [MODE=fast]");
  to.add("files", CommandWords{&team.files}, {},
         "files and folders of the program, which are part of its games' identity; by default, the "
         "words of the command that are files");
  to.add("files_hash", FreeText{&team.files_hash}, {},
         "the contents of these files, recorded by AutoRef");
  to.parameter(
      team.program.answer_s,
      {"answer_s", positive(3600), "how long the program may take to answer, in wall-clock time"});
  to.parameter(team.program.memory_mb,
               {"memory_mb", {16, 1 << 20}, "memory limit of each of the program's processes"});
  to.parameter(team.robots, {"robots", {1, kMaxRobots}, "number of robots on the field"});
  list_robots(team, types, to);
  to.add("players", &team.players, {}, "robots that differ from the rest of the team, by number");
  for (auto& [number, player] : team.players) {
    list_robots(player, types, to.below("players").below(std::to_string(number)));
  }
  // The range depends on the strategy's parameter; check_team() checks it.
  to.add("params", &team.params, {-1e9, 1e9}, "parameters of the strategy, by name");
}

// Lists the numbers of a rule book that are settings of the match itself.
void list_numbers_of_match(RuleBook& rules, Branch to) {
  for (const std::string_view name : kNumbersOfMatch) {
    RuleBook::visit(rules, [name, &to](auto& value, const Parameter& about) {
      if (about.name == name) to.parameter(value, about);
    });
  }
}

// Lists the other numbers.
void list_rule_numbers(RuleBook& rules, std::vector<Setting>& list) {
  RuleBook::visit(rules, [&list](auto& value, const Parameter& about) {
    const std::string path = path_of_number(about.name);
    if (path.starts_with(kRuleNumberBranch)) list.push_back(setting_of(path, value, about));
  });
}

void list_match(GameSettings& game, std::vector<Setting>& list) {
  Branch to(list, "match.");
  to.word("rules", RulesChoice{&game}, rule_book_names(),
          "rule book; also sets rule, switch, half_s, extra_half_s, change_ends, field, robots, "
          "kickers, dribblers and latency_error_s");
  referee::Match::visit(game.match, [&](auto& value, const Parameter& about) {
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, RuleBook>) {
      list_numbers_of_match(value, to);
    } else {
      to.parameter(value, about);
    }
  });
  list_rule_numbers(game.match.rules, list);
  Branch switches(list, std::string(kRuleSwitchBranch));
  for (const RuleEntry& entry : rule_table())
    switches.parameter(game.match.rules.in_force[entry.rule], {entry.name, entry.about});
}

// Makes the presets of ball and camera accept files.
void accept_files(GameSettings& game, std::vector<Setting>& settings) {
  for (Setting& setting : settings) {
    if (auto* ball = std::get_if<BallPreset>(&setting.target)) {
      ball->contacts = &game.sim.contacts;
      ball->measured = &game.measured_balls;
    } else if (auto* camera = std::get_if<CameraPreset>(&setting.target)) {
      camera->measured = &game.measured_cameras;
    }
  }
}

// Lists the world's parameters, including the robots'.
void list_world(GameSettings& game, std::vector<Setting>& list) {
  std::vector<Setting> world;
  Branch(world, "sim.").parameters(game.sim);
  accept_files(game, world);
  std::vector<Setting> robot = settings_of(game.robot, "sim.");
  const auto place = std::find_if(world.begin(), world.end(), [](const Setting& setting) {
    return setting.path.starts_with("sim.placement.");
  });
  world.insert(place, std::make_move_iterator(robot.begin()), std::make_move_iterator(robot.end()));
  append(std::move(world), list);
}

}  // namespace

void list_preset(sim::Configuration& sim, Branch& to) {
  to.word("camera", CameraPreset{&sim}, sim::camera_preset_names(),
          "sets vision, frame_rate_hz, command_loss and latency_s");
}

void list_preset(sim::BallParameters& ball, Branch& to) {
  to.word(kPresetName, BallPreset{&ball}, sim::ball_preset_names(),
          "sets how the ball slides, rolls and hops");
}

void list_preset(sim::KickerParameters& kicker, Branch& to) {
  to.word(kPresetName, KickerPreset{&kicker}, sim::kicker_preset_names(),
          "sets all parameters of the kicker");
}

void list_preset(sim::DribblerParameters& dribbler, Branch& to) {
  to.word(kPresetName, DribblerPreset{&dribbler}, sim::dribbler_preset_names(),
          "sets how the dribbler grips the ball");
}

std::vector<Setting> settings_of(GameSettings& game) {
  std::vector<Setting> list;
  list_types(game.types, Branch(list, ""));
  list_measured(game, list);
  list_team(game.a, game.types, Branch(list, "teams.a."));
  list_team(game.b, game.types, Branch(list, "teams.b."));
  list_match(game, list);
  Branch(list, "field.").parameters(game.field);
  list_world(game, list);
  Branch(list, "").parameter(game.seed, {"seed", {0, 0x1p64}, "the game's random seed"});
  return list;
}

std::vector<Setting> settings_of(TeamSettings& team, const RobotTypes& types,
                                 const std::string& prefix) {
  std::vector<Setting> list;
  list_team(team, types, Branch(list, prefix));
  return list;
}

std::vector<Setting> settings_of(sim::RobotSpec& robot, const std::string& prefix) {
  std::vector<Setting> list;
  Branch(list, prefix).parameters(robot);
  return list;
}

std::vector<Setting> settings_of(RobotChanges& changes) {
  std::vector<Setting> list;
  list_changes(changes, Branch(list, ""));
  return list;
}

std::vector<Setting> ball_settings(sim::Configuration& sim, const std::string& prefix) {
  return settings_at({"ball", "contacts"}, sim, prefix);
}

std::vector<Setting> camera_settings(sim::Configuration& sim, const std::string& prefix) {
  return settings_at({"vision", "frame_rate_hz", "latency_s", "radio.command_loss"}, sim, prefix);
}

}  // namespace autoref::game
