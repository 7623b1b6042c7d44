// Checks and hashes all settings of a game.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "game/settings/fields.hpp"
#include "game/settings/robot_types.hpp"
#include "game/settings/setting_value.hpp"
#include "io/checksum.hpp"
#include "io/words.hpp"
#include "soccer/parameters.hpp"
#include "soccer/rules/rule_changes.hpp"
#include "strategies/registry.hpp"

namespace autoref::game {
namespace {

using strategies::Tunable;

[[noreturn]] void refuse_unknown_param(const strategies::Entry& strategy, const std::string& path,
                                       const std::string& param) {
  const std::string what =
      fmt::format(": strategy '{}' has no parameter '{}'", strategy.name, param);
  if (strategy.params.empty()) throw SettingError(path, what + "; it has none");
  std::vector<std::string> known;
  for (const Tunable& tunable : strategy.params) known.emplace_back(tunable.name);
  const std::string nearest = io::suggestion(param, known);
  throw SettingError(path, fmt::format("{}{} Known here: {}", what, nearest.empty() ? "." : nearest,
                                       io::listed(known)));
}

void check_param(const Tunable& tunable, const std::string& path, double value) {
  if (tunable.is_flag ? value == 0 || value == 1 : tunable.range.contains(value)) return;
  const std::string allowed =
      tunable.is_flag ? "0 or 1" : "a number " + text_of(tunable.range, unit_of(tunable.name));
  throw SettingError(path, fmt::format(": expected {}, found '{}'", allowed, value));
}

void refuse_two_teams(const GameSettings& game, const TeamSettings& team, std::string_view name) {
  const std::string path = fmt::format("{}.strategy", name);
  if (team.program.command.empty() || !game.given.contains(path)) return;
  throw SettingError(path, ": the team also has a command; remove one of them");
}

// A program can have any parameters; a team on the network gets none.
void check_params(const TeamSettings& team, std::string_view name) {
  if (!team.program.command.empty()) return;
  if (team.strategy == kNetworkStrategy) {
    if (team.params.empty()) return;
    throw SettingError(fmt::format("{}.params", name), ": a team on the network has no parameters");
  }
  const strategies::Entry* strategy = strategies::find_strategy(team.strategy);
  if (strategy == nullptr) {
    throw std::invalid_argument(fmt::format("unknown strategy '{}'", team.strategy));
  }
  for (const auto& [param, value] : team.params) {
    const std::string path = fmt::format("{}.params.{}", name, param);
    const auto tunable =
        std::find_if(strategy->params.begin(), strategy->params.end(),
                     [&param = param](const Tunable& its) { return its.name == param; });
    if (tunable == strategy->params.end()) refuse_unknown_param(*strategy, path, param);
    check_param(*tunable, path, value);
  }
}

void check_speeds(const GameSettings& game, const sim::TeamSpec& spec, std::string_view name) {
  const double most_mps = sim::fastest_mps(game.sim);
  for (const sim::RobotSpec& robot : spec.robots) {
    const double robot_mps = sim::fastest_mps(robot);
    if (robot_mps <= most_mps) continue;
    throw SettingError(
        "sim.substeps",
        fmt::format(": a value of {} at {} frames per second limits all speeds to {:.4g} m/s, but "
                    "robots of {} drive or kick at up to {:.4g} m/s; use more substeps",
                    game.sim.substeps, game.sim.frame_rate_hz, most_mps, name, robot_mps));
  }
}

void check_robots(const GameSettings& game, const TeamSettings& team, std::string_view name) {
  const sim::TeamSpec spec = spec_of(game, team, name);
  for (const auto& [number, player] : team.players) {
    try {
      sim::validate(spec.robots[static_cast<std::size_t>(number)]);
    } catch (const OutOfRange& error) {
      throw SettingError(fmt::format("{}.players.{}", name, number),
                         fmt::format(": combined with the team's settings, {}", error.what()));
    }
  }
  check_speeds(game, spec, name);
}

// Validates the part of the world with settings below `branch`.
template <typename Part>
void check_world(const std::string& branch, const Part& part) {
  try {
    sim::validate(part);
  } catch (const OutOfRange& error) {
    throw SettingError(branch + error.path(), error.text());
  }
}

// The numbers of a rule book that differ from the official ones, by path. The others follow from
// the book's name.
std::set<std::string> changed_numbers(const GameSettings& game) {
  std::set<std::string> paths;
  for (RuleChange& change : rule_changes(game.match.rules, game.field))
    if (change.path.starts_with(kRuleNumberBranch)) paths.insert(std::move(change.path));
  return paths;
}

// The hash covers the values that types change and presets set, but not their names.
bool is_given_by_name(const Setting& setting) {
  return std::holds_alternative<TypeName>(setting.target) ||
         setting.path.starts_with(kMeasuredBranch) ||
         std::holds_alternative<ChangesOf>(setting.target) ||
         std::holds_alternative<RobotTypes*>(setting.target);
}

// The values in which a team's or a player's robots differ from the game's.
template <typename Of>
std::string robots_text(const GameSettings& game, std::string_view path, const Of& of) {
  std::string text;
  for (const auto& [name, value] : merged(game.types, of.type, of.changes)) {
    text += fmt::format("{}.{}={}\n", path, name, spelt(value));
  }
  return text;
}

std::string team_text(const GameSettings& game, std::string_view path, const TeamSettings& team) {
  std::string text = robots_text(game, path, team);
  for (const auto& [number, player] : team.players) {
    text += robots_text(game, fmt::format("{}.players.{}", path, number), player);
  }
  return text;
}

// Lines of values separated by spaces.
class ValueLines {
 public:
  template <typename... Values>
  void add(const Values&... values) {
    ((text_ += fmt::format("{} ", values)), ...);
    text_ += "\n";
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add_robots(const sim::RobotStates& robots, Side side, ValueLines& lines) {
  for (const sim::RobotState& robot : robots) {
    lines.add(name_of(side), robot.number, robot.position_m.x(), robot.position_m.y(),
              robot.heading.x(), robot.heading.y(), robot.velocity_mps.x(), robot.velocity_mps.y(),
              robot.angular_velocity_radps);
  }
}

void add_ball(const sim::BallState& ball, ValueLines& lines) {
  lines.add("ball", ball.position_m.x(), ball.position_m.y(), ball.velocity_mps.x(),
            ball.velocity_mps.y(), ball.height_m, ball.vertical_mps, ball.is_rolling);
}

void add_signal(const referee::MidwayStart& start, ValueLines& lines) {
  const RefereeSignal& signal = *start.signal;
  lines.add(name_of(signal.stage), signal.stage_time_left_s, signal.blue_on_positive_half);
  for (const Side side : kSides) {
    lines.add(signal.goals[side], start.goals_in_earlier_halves[side], signal.yellow_cards[side],
              signal.red_cards[side], fmt::format("{}", fmt::join(signal.yellow_left_s[side], " ")),
              signal.fouls[side], signal.timeouts_left[side], signal.timeout_left_s[side],
              signal.can_place_ball[side]);
  }
}

void add_frame(const Frame& frame, ValueLines& lines) {
  lines.add("seen", frame.time_s);
  for (const Side side : kSides) {
    for (const RobotObservation& robot : frame.robots[side])
      lines.add(name_of(side), robot.number, robot.position_m.x(), robot.position_m.y(),
                robot.heading.x(), robot.heading.y());
  }
  if (frame.ball)
    lines.add("ball", frame.ball->position_m.x(), frame.ball->position_m.y(),
              frame.ball->height_m.value_or(-1));
}

void add_ghost(const Ghost& ghost, ValueLines& lines) {
  lines.add("ghost", name_of(ghost.side), fmt::format("{}", fmt::join(ghost.touches_s, " ")));
  for (const GhostFrame& frame : ghost.frames) {
    lines.add("at", frame.time_s);
    add_robots(frame.robots, ghost.side, lines);
    if (frame.ball) add_ball(*frame.ball, lines);
  }
}

std::string start_text(const GameSettings& game) {
  if (!game.start) return "";
  const StartState& start = *game.start;
  ValueLines lines;
  for (const Side side : kSides) add_robots(start.robots[side], side, lines);
  add_ball(start.ball, lines);
  const referee::MidwayStart& midway_start = start.referee;
  lines.add(midway_start.restart ? name_of(*midway_start.restart) : "play", midway_start.ball_m.x(),
            midway_start.ball_m.y(), midway_start.is_stopped);
  if (midway_start.signal) add_signal(midway_start, lines);
  for (const Frame& frame : start.seen_before) add_frame(frame, lines);
  if (start.ghost) add_ghost(*start.ghost, lines);
  return lines.text();
}

std::string scene_text(const GameSettings& game) {
  if (!game.scene) return "";
  std::string text =
      fmt::format("scene {} {}", game.scene->lasts_s, fmt::join(game.scene->ends, ""));
  SceneWeights::visit(game.scene->weights, [&text](double weight, const Parameter& /*about*/) {
    text += fmt::format(" {}", weight);
  });
  return text + "\n";
}

// A game's identity includes the content of a program's files, but not their names.
bool names_no_content(const Setting& setting) {
  const auto* text = std::get_if<FreeText>(&setting.target);
  return setting.path.ends_with(".files") ||
         (setting.path.ends_with(".files_hash") && text != nullptr && text->text->empty());
}

}  // namespace

void check_team(const GameSettings& game, const TeamSettings& team, std::string_view path) {
  refuse_two_teams(game, team, path.substr(path.rfind('.') + 1));
  check_params(team, path);
  check_robots(game, team, path);
}

void check_rule_numbers(const GameSettings& game) {
  try {
    check_rules(game.match.rules, game.field);
  } catch (const OutOfRange& error) {
    throw SettingError(std::string(kRuleNumberBranch) + error.path(), error.text());
  }
}

void check_game(const GameSettings& game) {
  if (game.match.control == referee::Control::kHuman ||
      game.match.control == referee::Control::kNone) {
    throw SettingError("match.control",
                       ": only autoref or game-controller can command a simulated game; the others "
                       "are for recorded games (autoref referee log)");
  }
  check_team(game, game.a, "teams.a");
  check_team(game, game.b, "teams.b");
  check_world("", game.field);
  check_rule_numbers(game);
  check_world("sim.", game.sim);
  check_world("sim.", game.robot);
}

std::uint64_t configuration_hash(const GameSettings& game) {
  GameSettings copy = game;
  std::string text;
  const std::set<std::string> changed = changed_numbers(game);
  // Hashes a canonical text, one line per setting, so the hash depends neither on memory layout nor
  // on how the settings were given.
  for (const Setting& setting : settings_of(copy)) {
    if (is_alias(setting) || is_given_by_name(setting) || names_no_content(setting)) continue;
    if (setting.path.starts_with(kRuleNumberBranch) && !changed.contains(setting.path)) continue;
    text += fmt::format("{}={}\n", setting.path, value_of(setting));
  }
  text += team_text(game, "teams.a", game.a) + team_text(game, "teams.b", game.b);
  text += start_text(game) + scene_text(game);
  io::ByteHash hash;
  hash.add(text);
  return hash.value();
}

}  // namespace autoref::game
