#include "logs/log_game.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::logs {
namespace {

// Unix times of 1 January.
constexpr std::int64_t kYear2000_s = 946'684'800;
constexpr std::int64_t kYear2018_s = 1'514'764'800;
constexpr std::int64_t kYear2100_s = 4'102'444'800;
// Limits between single and double size (6.05 m, 8.09 m), and between Divisions B and A (9 m, 12
// m).
constexpr double kDoubleSize_m = 7;
constexpr double kLongestOfB_m = 10.5;

std::optional<std::int64_t> date_of(const league::LogSummary& log) {
  const std::int64_t unix_s = log.first_ns / 1'000'000'000;
  const bool is_date = unix_s >= kYear2000_s && unix_s < kYear2100_s;
  return is_date ? std::optional(unix_s) : std::nullopt;
}

bool has_boxes(const league::LogSummary& log, const std::optional<std::int64_t>& date_s) {
  if (log.field && !log.field_gaps.defence_area)
    return log.field->defence_area.shape == DefenceArea::Shape::kBox;
  return (date_s && *date_s >= kYear2018_s) || (log.field && log.field->length_m > kLongestOfB_m);
}

std::string book_of(const league::LogSummary& log, const std::optional<std::int64_t>& date_s) {
  const double length_m = log.field ? log.field->length_m : 0;
  if (has_boxes(log, date_s)) return length_m > kLongestOfB_m ? "2026-a" : "2026-b";
  if (length_m > kDoubleSize_m) return "2014-double";
  return date_s ? "2014" : "paper";
}

// The first command in the log if it shows that, at the start of the log, play is on or a restart
// is pending.
std::optional<Command> play_begun(const RecordedFacts& facts) {
  if (facts.commands.empty()) return std::nullopt;
  const Command first = facts.commands.front().command;
  switch (first.kind) {
    case CommandKind::kNormalStart:
    case CommandKind::kForceStart:
    case CommandKind::kPreparePenalty:
    case CommandKind::kDirectFree:
    case CommandKind::kIndirectFree:
      return first;
    default:
      return std::nullopt;
  }
}

}  // namespace

GuessedRules guessed_rules(const league::LogSummary& log) {
  const std::optional<std::int64_t> date_s = date_of(log);
  const std::string field =
      log.field ? fmt::format("a field of {} x {} m", log.field->length_m, log.field->width_m)
                : "an unknown field";
  const std::string date =
      date_s ? fmt::format("recorded on {:%Y-%m-%d}", fmt::gmtime(*date_s)) : "without a date";
  return {book_of(log, date_s), field + ", " + date};
}

Field field_in(const league::LogSummary& log, const Field& of_book) {
  if (!log.field) return of_book;
  Field field = *log.field;
  if (log.field_gaps.penalty_mark) field.penalty_mark_m = of_book.penalty_mark_m;
  if (log.field_gaps.defence_area) field.defence_area = of_book.defence_area;
  // Vision does not report this; a field with the rule book's walls is assumed to have its goals.
  constexpr double kSameWall_m = 1_mm;
  const bool has_its_walls =
      std::abs(field.run_off_m - of_book.run_off_m) < kSameWall_m &&
      std::abs(field.behind_goal_lines_m() - of_book.behind_goal_lines_m()) < kSameWall_m;
  field.goal_sides_reach_wall = has_its_walls && of_book.goal_sides_reach_wall;
  return field;
}

game::GameSettings logged_game(const std::string& book, const RecordedFacts& facts,
                               const RecordedGame& recorded) {
  game::GameSettings game;
  game::choose_rules(book, game);
  game.field = field_in(facts.log, game.field);
  if (recorded.half_s) game.match.half_s = *recorded.half_s;
  if (recorded.halves > 0) game.match.halves = recorded.halves;
  if (recorded.extra_half_s) game.match.rules.extra_half_s = *recorded.extra_half_s;
  game.match.knockout = recorded.is_knockout;
  if (facts.noise) {
    game.sim.vision.ball_noise_m = facts.noise->ball_m;
    game.sim.vision.robot_noise_m = facts.noise->robot_m;
    game.sim.vision.robot_noise_rad = facts.noise->robot_rad;
  }
  if (recorded.first_kickoff) game.match.first_kickoff = *recorded.first_kickoff;
  game.match.control = facts.last_signal ? referee::Control::kHuman : referee::Control::kNone;
  game.a.robots = std::max(1, facts.robots[Side::kWest]);
  game.b.robots = std::max(1, facts.robots[Side::kEast]);
  return game;
}

game::EventGame event_game_of(const PerSide<std::string>& names, const RuleBook& rules) {
  const std::optional<GameSetup> official = find_game_setup(rules.name);
  return {{{game::EventTeam{"", names[Side::kWest]}, game::EventTeam{"", names[Side::kEast]}}},
          official ? text_of(rule_changes(rules, official->field)) : ""};
}

void check_judged(const game::GameSettings& game) {
  constexpr double kAnyRunOff_m = 2;
  Field field = game.field;
  field.run_off_m = kAnyRunOff_m;
  field.goal_line_run_off_m = kAnyRunOff_m;
  sim::validate(field);
  game::check_rule_numbers(game);
  referee::Referee{game::referee_configuration(game::resolved(game))};
}

std::vector<std::string> gaps_of(const RecordedFacts& facts, const game::GameSettings& game,
                                 const std::function<bool(const std::string& path)>& is_set) {
  std::vector<std::string> gaps;
  const auto note = [&](bool is_missing, const std::string& path, const std::string& gap) {
    if (is_missing && !is_set(path)) gaps.push_back(gap);
  };
  const Field& field = game.field;
  const RecordedGame& recorded = facts.games.front();
  const bool has_referee = facts.last_signal.has_value();
  note(!facts.log.field, "field.length_m",
       fmt::format("no geometry: using the field of the rules {}, {} x {} m (change with --rules, "
                   "or --set field.length_m=... etc.)",
                   game.match.rules.name, field.length_m, field.width_m));
  note(facts.log.field && facts.log.field_gaps.penalty_mark, "field.penalty_mark_m",
       fmt::format(
           "the geometry has no penalty mark: using {} m from the goal line (change with --set "
           "field.penalty_mark_m=...)",
           field.penalty_mark_m));
  note(facts.log.field && facts.log.field_gaps.defence_area, "field.defence_area.depth_m",
       fmt::format("the geometry has no defence areas: using a depth of {} m as in the rules {} "
                   "(change with --set field.defence_area.depth_m=...)",
                   field.defence_area.depth_m, game.match.rules.name));
  note(!has_referee, "match.control",
       "no referee packets: assuming that play is on throughout; there are no calls to compare "
       "AutoRef's with (to let AutoRef command the game: --control autoref)");
  const bool is_alone = game.match.control == referee::Control::kAutoref;
  note(
      is_alone && !recorded.half_s, "match.half_s",
      fmt::format("the clock of the first half is missing: using halves of {} s (change with --set "
                  "match.half_s=...)",
                  game.match.half_s));
  note(is_alone && !recorded.first_kickoff, "match.first_kickoff",
       fmt::format(
           "the first kick-off is missing: giving it to {} (change with --first-kickoff west|east)",
           name_of(game.match.first_kickoff)));
  const std::optional<Command> begun = play_begun(facts);
  if (is_alone && begun) {
    note(true, "",
         fmt::format(
             "the log starts in the middle of play ({}): AutoRef starts with a kick-off of its "
             "own, which counts as a wrong call",
             name_of(*begun)));
  }
  for (const Side side : kSides) {
    note(facts.robots[side] == 0, "",
         fmt::format("robots of the {} team are never detected",
                     side == Side::kWest ? "yellow" : "blue"));
  }
  note(!facts.has_ball, "", "the ball is never detected, so AutoRef cannot make calls about it");
  return gaps;
}

}  // namespace autoref::logs
