#include "app/game/log_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/game/scenario_game.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"
#include "logs/log_game.hpp"
#include "logs/logged_ghost.hpp"
#include "logs/logged_state.hpp"
#include "logs/recorded_facts.hpp"
#include "logs/user_log.hpp"
#include "referee/machine/guards.hpp"
#include "referee/referee.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::app {
namespace {

// After the recorded play, the ghost stands still for this long: time for a ball on its way to
// reach the goal.
constexpr double kAfterGhost_s = 2;

game::TeamSettings& team_in(game::GameSettings& game, Side side) {
  return side == game.match.a_plays ? game.a : game.b;
}

bool is_given(const game::GameSettings& game, std::string_view path) {
  return std::any_of(game.given.begin(), game.given.end(),
                     [path](const std::string& one) { return one.starts_with(path); });
}

// The robots on the field, and those that cards keep off it.
int team_size_in(const game::StartState& start, Side side) {
  const int on = static_cast<int>(start.robots[side].size());
  const std::optional<RefereeSignal>& signal = start.referee.signal;
  if (!signal) return std::max(1, on);
  const int off = static_cast<int>(signal->yellow_left_s[side].size()) + signal->red_cards[side];
  return std::clamp(std::min(on, signal->robots_allowed[side]) + off, std::max(1, on), kMaxRobots);
}

// The game of the log that is played at that time.
const logs::RecordedGame& game_at(const logs::RecordedFacts& facts, double at_s) {
  const auto next =
      std::find_if(facts.games.begin() + 1, facts.games.end(),
                   [at_s](const logs::RecordedGame& game) { return game.begins_s > at_s; });
  return *(next - 1);
}

// Settings that the user does not set are taken from the log.
void take_defaults(const logs::RecordedFacts& facts, double at_s, const game::StartState& start,
                   game::GameSettings& game) {
  const game::GameSettings logged =
      logs::logged_game(game.match.rules.name, facts, game_at(facts, at_s));
  if (!is_given(game, "field.")) game.field = logged.field;
  const auto take = [&game](std::string_view path, auto& value, const auto& of_log) {
    if (!is_given(game, path)) value = of_log;
  };
  take("match.half_s", game.match.half_s, logged.match.half_s);
  const bool is_whole = facts.last_signal && facts.last_signal->stage == Stage::kPostGame;
  if (is_whole) take("match.halves", game.match.halves, logged.match.halves);
  take("match.knockout", game.match.knockout, logged.match.knockout);
  take("match.first_kickoff", game.match.first_kickoff, logged.match.first_kickoff);
  take(std::string(kRuleNumberBranch) + "extra_half_s", game.match.rules.extra_half_s,
       logged.match.rules.extra_half_s);
  for (const Side side : kSides) {
    const bool is_a = side == game.match.a_plays;
    take(is_a ? "teams.a.robots" : "teams.b.robots", team_in(game, side).robots,
         team_size_in(start, side));
  }
}

void keep_inside_walls(game::StartState& start, const Field& field) {
  const auto clamped = [&field](const Vec2& position_m, double radius_m) {
    const double x_m = field.wall_x_m() - radius_m;
    const double y_m = field.wall_y_m() - radius_m;
    return Vec2(std::clamp(position_m.x(), -x_m, x_m), std::clamp(position_m.y(), -y_m, y_m));
  };
  const auto keep = [&](sim::RobotStates& robots) {
    for (sim::RobotState& robot : robots)
      robot.position_m = clamped(robot.position_m, kRobotRadius_m);
  };
  for (sim::RobotStates& robots : start.robots.values) keep(robots);
  start.ball.position_m = clamped(start.ball.position_m, kBallRadius_m);
  if (!start.ghost) return;
  for (game::GhostFrame& frame : start.ghost->frames) {
    keep(frame.robots);
    if (frame.ball) frame.ball->position_m = clamped(frame.ball->position_m, kBallRadius_m);
  }
}

// The default settings under the rule book that the log seems to use, with the user's assignments.
game::GameSettings default_game(const std::string& log, const logs::RecordedFacts& facts,
                                const std::string& seed, const game::Assignments& assignments) {
  const bool has_rules = std::any_of(
      assignments.begin(), assignments.end(),
      [](const game::Assignment& one) { return game::full_path(one.path) == "match.rules"; });
  game::Assignments all = assignments;
  if (!has_rules) {
    const logs::GuessedRules guessed = logs::guessed_rules(facts.log);
    io::write_message(stderr, fmt::format("autoref: {}: {}: using the rules {} (change with --set "
                                          "match.rules=BOOK)\n",
                                          log, guessed.reason, guessed.book));
    all.insert(all.begin(), {"--from", "match.rules", guessed.book});
  }
  game::GameSettings game;
  game::assign_all(all, game);
  if (!seed.empty()) game::locate_errors("--seed", [&] { game::set_by_path(game, "seed", seed); });
  return game;
}

// A kick-off and a penalty kick are prepared again, which takes another time than in the log.
void refuse_restart_to_come(double at_s, const referee::MidwayStart& start) {
  const bool is_prepared = start.restart && (start.restart->kind == CommandKind::kPrepareKickoff ||
                                             start.restart->kind == CommandKind::kPreparePenalty);
  if (!is_prepared) return;
  throw std::invalid_argument(
      fmt::format("{} is not taken yet at {} s in the log; a ghost needs a time after the kick",
                  name_of(*start.restart), at_s));
}

void check_time_left(const LogInstant& instant, const game::StartState& start) {
  const std::optional<RefereeSignal>& signal = start.referee.signal;
  if (!signal || signal->stage_time_left_s > 0) return;
  if (!referee::is_running(signal->stage)) return;
  throw std::invalid_argument(
      fmt::format("the time of the half is over at {} s in the log {}; give an earlier time",
                  instant.at_s, instant.log));
}

RecordedSequel add_ghost(const std::string& log, double at_s, Side side, game::GameSettings& game,
                         game::StartState& start) {
  logs::LoggedGhost logged = logs::logged_ghost(log, at_s, side);
  refuse_restart_to_come(at_s, start.referee);
  const RecordedSequel sequel{logged.ghost.frames.back().time_s, logged.scorer};
  start.ghost = std::move(logged.ghost);
  game.scene.emplace();
  game.scene->lasts_s = sequel.lasts_s + kAfterGhost_s;
  // Play may go on after the half's time.
  std::optional<RefereeSignal>& signal = start.referee.signal;
  if (signal) signal->stage_time_left_s = std::max(signal->stage_time_left_s, game.scene->lasts_s);
  return sequel;
}

}  // namespace

LogInstant instant_in(const std::string& from) {
  const std::size_t at = from.rfind('@');
  const std::optional<double> seconds =
      at == std::string::npos ? std::nullopt : io::number_in(from.substr(at + 1));
  if (!seconds || at == 0) {
    throw io::InputError(
        {"--from"}, "",
        fmt::format("expected LOG@SECONDS, such as game.log.gz@83.2, found '{}'", from));
  }
  return {from.substr(0, at), *seconds};
}

GameFromLog game_from_log(const LogInstant& instant, const std::string& file,
                          const std::string& seed, const std::string& ghost,
                          const game::Assignments& assignments) {
  const std::string log = logs::seekable_log(instant.log);
  GameFromLog from;
  game::GameSettings& game = from.game;
  std::optional<logs::RecordedFacts> facts;
  if (file.empty()) {
    facts = logs::read_facts(instant.log, log);
    game = default_game(instant.log, *facts, seed, assignments);
  } else {
    game = game_in(file, seed, assignments);
  }
  if (game.match.control != referee::Control::kAutoref) {
    throw io::InputError({"--from"}, "",
                         "only AutoRef can command a game that begins with the state of a log; set "
                         "match.control=autoref");
  }
  game::locate_errors("--from", [&] {
    logs::LoggedState logged = logs::logged_state(log, instant.at_s);
    if (facts) take_defaults(*facts, instant.at_s, logged.start, game);
    game::check_game(game);
    logs::check_same_field(logged, game.field);
    if (!ghost.empty()) {
      const Side side = ghost == colour_of(Side::kWest) ? Side::kWest : Side::kEast;
      from.sequel = add_ghost(log, instant.at_s, side, game, logged.start);
    }
    check_time_left(instant, logged.start);
    referee::Referee(game::referee_configuration(game::resolved(game))).begin(logged.start.referee);
    for (const Side side : kSides) logs::renumber(logged.start, side, team_in(game, side).robots);
    keep_inside_walls(logged.start, game.field);
    game.start = std::move(logged.start);
  });
  return from;
}

}  // namespace autoref::app
