#include "game/loop/game_configuration.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "referee/machine/penalty_outcome.hpp"
#include "sim/camera.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::game {
namespace {

// Maximum time spent outside halves and breaks, waiting for clients and restarts.
constexpr double kSlack_s = 300;

// If the clock stops along with play, a half may take up to this many times its length. A stop
// contains at most two waits of 15 s, so a game ends in time if play lasts 3.3 s on average between
// stops.
constexpr double kStandstill = 10;

// The factor if the teams place the ball. A placement takes up to 30 s, and each team can fail a
// few times per half.
constexpr double kStandstillOfTeams = 20;

// Programs that run the team given as their first argument.
constexpr std::array<std::string_view, 10> kInterpreters = {
    "python", "node", "java", "ruby", "lua", "perl", "julia", "bash", "sh", "deno"};

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

double failed_placements_s(const referee::Match& match) {
  if (match.placement == referee::PlacedBy::kSimulator) return 0;
  const RuleBook& rules = match.rules;
  return 2 * match.halves * rules.placement_failures * 2 * rules.placement_time_s;
}

// How many times longer than under the official rules the referee may wait in a stop.
double waiting_factor(const RuleBook& rules) {
  const RuleBook usual;
  return std::max(
      {1.0, rules.ready_timeout_s / usual.ready_timeout_s,
       rules.start_timeout_s / usual.start_timeout_s, rules.halt_s / usual.ready_timeout_s,
       rules.placement_time_s / usual.placement_time_s, rules.interference_s / usual.interference_s,
       static_cast<double>(rules.retakes) / usual.retakes});
}

double longest_shootout_s(const RuleBook& rules) {
  const double kick_s = 2 * rules.ready_timeout_s + rules.penalty_time_s;
  return 2 * referee::kMostShootoutKicks * kick_s;
}

constexpr double kDivisionA_m = 12.0;
constexpr double kDivisionB_m = 9.0;
constexpr double kHeightIn2026_m = 6.25;  // cameras hang at 6.0 to 6.5 m

}  // namespace

RuleBook obeyed_rules(const GameConfiguration& game, const TeamConfiguration& team) {
  return team.laws ? autoref::obeyed_rules(game.match.rules, *team.laws) : game.match.rules;
}

const TeamConfiguration& team_on(const GameConfiguration& game, Side side) {
  return side == game.match.a_plays ? game.a : game.b;
}

std::string program_name(const std::vector<std::string>& command) {
  std::string program = stem_of(command.at(0));
  const auto begins = [&program](std::string_view name) { return program.starts_with(name); };
  if (std::none_of(kInterpreters.begin(), kInterpreters.end(), begins)) return program;
  const auto script = std::find_if(command.begin() + 1, command.end(),
                                   [](const std::string& word) { return !word.starts_with('-'); });
  return script == command.end() ? program : stem_of(*script);
}

std::string name_of(const TeamConfiguration& team) {
  return team.program ? program_name(team.program->command) : team.strategy;
}

PerSide<std::string> shown_names(const GameConfiguration& game) {
  PerSide<std::string> names;
  for (const Side side : kSides) {
    names[side] = name_of(team_on(game, side));
    const char letter = side == game.match.a_plays ? 'a' : 'b';
    if (name_of(game.a) == name_of(game.b)) names[side] += fmt::format(" ({})", letter);
  }
  return names;
}

std::string rule_changes_in(const GameConfiguration& game) {
  return text_of(rule_changes(game.match.rules, game.field));
}

referee::Configuration referee_configuration(const GameConfiguration& game) {
  referee::Configuration configuration;
  static_cast<referee::Match&>(configuration) = game.match;
  if (configuration.control == referee::Control::kGameController)
    configuration.control = referee::Control::kHuman;
  configuration.field = game.field;
  for (const Side side : kSides) {
    configuration.robots[side] = static_cast<int>(team_on(game, side).robots.size());
  }
  configuration.noise = {game.sim.vision.ball_noise_m, game.sim.vision.robot_noise_m,
                         game.sim.vision.robot_noise_rad};
  configuration.camera_error_m = game.sim.vision.camera_error_m;
  return configuration;
}

double longest_s(const referee::Match& match) {
  const RuleBook& rules = match.rules;
  const bool teams_place = match.placement == referee::PlacedBy::kTeams;
  const double standstill = teams_place ? kStandstillOfTeams : kStandstill;
  // The clock of the league's game controller stops whatever the rules.
  const bool clock_stops = rules.clock_stops || match.control == referee::Control::kGameController;
  const double stretch = clock_stops ? standstill * waiting_factor(rules) : 1;
  double longest_s = match.halves * (match.half_s * stretch + match.break_s) + kSlack_s +
                     failed_placements_s(match);
  if (rules.has(RuleId::kTimeouts)) longest_s += 2 * (rules.timeouts_s + rules.extra_timeouts_s);
  if (!match.knockout) return longest_s;
  return longest_s + 2 * rules.extra_half_s * stretch + 3 * match.break_s +
         longest_shootout_s(rules);
}

std::vector<CameraPosition> logged_cameras(const GameConfiguration& game) {
  const sim::VisionParameters& vision = game.sim.vision;
  int cameras = vision.cameras;
  double height_m = vision.camera_height_m;
  if (vision.reports_height && cameras == 4 && game.field.length_m >= kDivisionB_m) {
    cameras = game.field.length_m >= kDivisionA_m ? 2 : 1;
    height_m = kHeightIn2026_m;
  }
  sim::CameraPositions positions = sim::camera_positions(game.field, cameras, height_m);
  sim::draw_capture_ages(vision, game.sim.frame_rate_hz, game.seed,
                         {positions.data(), positions.size()});
  return {positions.begin(), positions.end()};
}

}  // namespace autoref::game
