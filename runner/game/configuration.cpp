#include "runner/game/configuration.hpp"

#include <fmt/format.h>

#include "referee/machine/shootout.hpp"

namespace autoref::runner {
namespace {

// Maximum time spent outside halves and breaks, waiting for clients and restarts.
constexpr double kSlack_s = 300;

// If the clock stops while play is stopped, a half may take up to this many times its length. A
// stop contains at most two waits of 15 s, so a game ends in time if play lasts 3.3 s on average
// between stops.
constexpr double kStandstill = 10;

// The same if the teams place the ball, which takes them up to 30 s, and their failures, of which a
// team may have a few in each half.
constexpr double kStandstillOfTeams = 20;

double failed_placements_s(const MatchConfiguration& match) {
  if (match.placement == referee::PlacedBy::kSimulator) return 0;
  const RuleBook& rules = match.rules;
  return 2 * match.halves * rules.placement_failures * 2 * rules.placement_time_s;
}

double longest_shootout_s(const RuleBook& rules) {
  const double kick_s = 2 * rules.ready_timeout_s + rules.penalty_time_s;
  return 2 * referee::kMostShootoutKicks * kick_s;
}

}  // namespace

const TeamConfiguration& team_on(const GameConfiguration& game, Side side) {
  return side == game.match.a_plays ? game.a : game.b;
}

PerSide<std::string> shown_names(const GameConfiguration& game) {
  PerSide<std::string> names;
  for (const Side side : kSides) {
    names[side] = team_on(game, side).strategy;
    const char letter = side == game.match.a_plays ? 'a' : 'b';
    if (game.a.strategy == game.b.strategy) names[side] += fmt::format(" ({})", letter);
  }
  return names;
}

referee::Configuration referee_configuration(const GameConfiguration& game) {
  referee::Configuration configuration;
  configuration.field = game.field;
  configuration.rules = game.match.rules;
  for (const Side side : kSides) {
    configuration.robots[side] = static_cast<int>(team_on(game, side).robots.size());
  }
  configuration.half_s = game.match.half_s;
  configuration.halves = game.match.halves;
  configuration.break_s = game.match.break_s;
  configuration.knockout = game.match.knockout;
  configuration.after_game = game.match.after_game;
  configuration.control = game.match.control;
  configuration.placement = game.match.placement;
  configuration.first_kickoff = game.match.first_kickoff;
  configuration.noise = {game.sim.vision.ball_noise_m, game.sim.vision.robot_noise_m,
                         game.sim.vision.robot_noise_rad};
  return configuration;
}

double longest_s(const MatchConfiguration& match) {
  const RuleBook& rules = match.rules;
  const bool teams_place = match.placement == referee::PlacedBy::kTeams;
  const double standstill = teams_place ? kStandstillOfTeams : kStandstill;
  const double stretch = rules.clock_stops ? standstill : 1;
  double longest_s = match.halves * (match.half_s * stretch + match.break_s) + kSlack_s +
                     failed_placements_s(match);
  if (rules.has(RuleId::kTimeouts)) longest_s += 2 * (rules.timeouts_s + rules.extra_timeouts_s);
  if (!match.knockout) return longest_s;
  return longest_s + 2 * rules.extra_half_s * stretch + 3 * match.break_s +
         longest_shootout_s(rules);
}

}  // namespace autoref::runner
