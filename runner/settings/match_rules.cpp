#include "runner/settings/match_rules.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "referee/machine/shootout.hpp"

namespace autoref::runner {
namespace {

// Extra time a game may take beyond its halves and breaks, for waiting for clients and restarts.
constexpr double kSlack_s = 300;

// If the clock stops while play is stopped, a game may take this many times the length of its
// halves. A stop has two waits of at most 15 s, so games with plays of 3.3 s on average still
// finish.
constexpr double kStandstill = 10;

RuleBook book_of(const std::string& name) {
  const std::optional<RuleBook> rules = find_rule_book(name);
  if (!rules) throw std::invalid_argument(fmt::format("unknown rule book '{}'", name));
  return *rules;
}

double longest_shootout_s(const RuleBook& rules) {
  const double kick_s = 2 * rules.ready_timeout_s + rules.penalty_time_s;
  return 2 * referee::kMostShootoutKicks * kick_s;
}

}  // namespace

void choose_rules(const std::string& book, GameConfiguration& game) {
  const RuleBook rules = book_of(book);
  const GameSetup setup = *find_game_setup(book);
  game.match.rules = book;
  game.match.in_force = rules.in_force;
  game.match.extra_half_s = rules.extra_half_s;
  game.match.half_s = setup.half_s;
  game.field = setup.field;
  game.a.robots = game.b.robots = setup.robots;
}

RuleBook rules_of(const MatchConfiguration& match) {
  RuleBook rules = book_of(match.rules);
  rules.in_force = match.in_force;
  rules.extra_half_s = match.extra_half_s;
  return rules;
}

const TeamConfiguration& team_on(const GameConfiguration& c, Side side) {
  return side == c.match.a_plays ? c.a : c.b;
}

referee::Configuration referee_configuration(const GameConfiguration& c) {
  referee::Configuration configuration;
  configuration.field = c.field;
  configuration.rules = rules_of(c.match);
  for (const Side side : kSides) configuration.robots[side] = team_on(c, side).robots;
  configuration.half_s = c.match.half_s;
  configuration.halves = c.match.halves;
  configuration.break_s = c.match.break_s;
  configuration.knockout = c.match.knockout;
  configuration.after_game = c.match.after_game;
  configuration.first_kickoff = c.match.first_kickoff;
  configuration.noise = {c.sim.vision.ball_noise_m, c.sim.vision.robot_noise_m,
                         c.sim.vision.robot_noise_rad};
  return configuration;
}

double longest_s(const MatchConfiguration& match) {
  const RuleBook rules = rules_of(match);
  const double stretch = rules.clock_stops ? kStandstill : 1;
  double longest_s = match.halves * (match.half_s * stretch + match.break_s) + kSlack_s;
  if (rules.has(RuleId::kTimeouts)) longest_s += 2 * (rules.timeouts_s + rules.extra_timeouts_s);
  if (!match.knockout) return longest_s;
  return longest_s + 2 * match.extra_half_s * stretch + 3 * match.break_s +
         longest_shootout_s(rules);
}

}  // namespace autoref::runner
