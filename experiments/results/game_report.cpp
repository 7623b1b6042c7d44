#include "experiments/results/game_report.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/results/game_row.hpp"
#include "io/checksum.hpp"
#include "io/json.hpp"
#include "soccer/rules/rule_changes.hpp"
#include "soccer/side.hpp"

namespace autoref::experiments {
namespace {

constexpr std::string_view kInterrupted = "interrupted";  // in place of an EndReason

std::string scene_end_text(game::SceneEnd end) {
  switch (end) {
    case game::SceneEnd::kTime:
      return "the scene's time ran out";
    case game::SceneEnd::kGoal:
      return "a goal was scored";
    case game::SceneEnd::kBallOut:
      return "the ball left the field";
    case game::SceneEnd::kFoul:
      return "a foul was called";
    case game::SceneEnd::kStop:
      return "another call stopped play";
  }
  throw std::logic_error("unknown end of a scene");
}

// "blue (b)".
std::string team_text(const game::GameConfiguration& game, bool is_a) {
  const Side side = is_a ? game.match.a_plays : opponent_of(game.match.a_plays);
  return fmt::format("{} ({})", colour_of(side), is_a ? 'a' : 'b');
}

std::string goals_text(const game::GameConfiguration& game, const game::GameRecord& record) {
  const auto [less, more] = std::minmax(record.goals_a, record.goals_b);
  const int lead = more - less;
  return fmt::format("{} leads by {} goal{}, and {} goals are enough to win",
                     team_text(game, record.goals_a > record.goals_b), lead, lead == 1 ? "" : "s",
                     game.match.rules.goals_to_win);
}

std::string shootout_text(const game::GameConfiguration& game, const game::GameRecord& record) {
  const std::array<int, 2> goals = record.shootout.value_or(std::array<int, 2>{});
  if (goals[0] == goals[1]) return "the shoot-out ended";
  return team_text(game, goals[0] > goals[1]) + " won the shoot-out";
}

// A game controller gives no reason; the record then keeps kTime.
std::string time_text(const game::GameConfiguration& game) {
  return game.match.control == referee::Control::kGameController
             ? "the game controller ended the game"
             : "playing time ran out";
}

double x_real_time(const GameReport& report) {
  return report.wall_s > 0 ? report.record.sim_s / report.wall_s : 0;
}

io::Json calls_json(const game::GameRecord& record) {
  io::Json calls;
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (is_call(entry.event)) calls[entry.name] = record.count(entry.event);
  }
  return calls;
}

// "24 throw in, 3 goal": events that occurred, with spaces instead of underscores.
std::string calls_text(const game::GameRecord& record) {
  std::string text;
  for (const referee::EventEntry& entry : referee::event_table()) {
    const int count = record.count(entry.event);
    if (!is_call(entry.event) || count == 0) continue;
    std::string name(entry.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
  }
  return text.empty() ? "none" : text;
}

std::string halves_text(const game::GameRecord& record) {
  std::string text;
  for (const std::array<int, 2>& goals : record.goals_by_half) {
    text += fmt::format("{}{}:{}", text.empty() ? "" : ", ", goals[0], goals[1]);
  }
  return text;
}

std::string line_of(std::string_view what, const std::string& a, const std::string& b) {
  return fmt::format("\n{:16}{:>7}{:>7}", what, a, b);
}

// The table of counts: one line per count, one column per team.
std::string counts_text(const game::GameRecord& record) {
  const auto& [a, b] = record.counts;
  const auto count = [&a = a, &b = b](std::string_view what, int game::PlayCounts::*member) {
    return line_of(what, std::to_string(a.*member), std::to_string(b.*member));
  };
  const auto share = [&](const game::PlayCounts& team) {
    const double in_play_s = std::max(record.ball_in_play_s, 1e-9);
    return fmt::format("{:.0f} %", 100 * team.possession_s / in_play_s);
  };
  return line_of("", "a", "b") + count("shots", &game::PlayCounts::shots) +
         count("  on goal", &game::PlayCounts::shots_on_goal) +
         count("passes tried", &game::PlayCounts::passes_tried) +
         count("  completed", &game::PlayCounts::passes_completed) +
         line_of("possession", share(a), share(b)) + count("fouls", &game::PlayCounts::fouls) +
         count("duels won", &game::PlayCounts::duels_won);
}

io::Json team_json(const game::GameConfiguration& game, Side side) {
  return {{"name", game::shown_names(game)[side]},
          {"strategy", game::name_of(game::team_on(game, side))},
          {"colour", colour_of(side)},
          {"side", name_of(side)}};
}

io::Json teams_json(const game::GameConfiguration& game) {
  const Side a = game.match.a_plays;
  return {{"a", team_json(game, a)}, {"b", team_json(game, opponent_of(a))}};
}

// The value of a count; numbers are rounded to three decimals.
template <typename Counts>
io::Json count_json(const Counts& counts, const game::CountField<Counts>& field) {
  return field.count != nullptr ? io::Json(counts.*field.count)
                                : io::Json(io::rounded(counts.*field.number, 3));
}

void add_counts(io::Json& json, const game::GameRecord& record,
                const game::CountField<game::PlayCounts>& field) {
  json[fmt::format("{}_a", field.name)] = count_json(record.counts[0], field);
  json[fmt::format("{}_b", field.name)] = count_json(record.counts[1], field);
}

// {"kick_off": {"chains": 3, "shots": 1, "goals": 0, "xg": 0.1}, ...}
io::Json chains_json(const game::PlayCounts& team) {
  io::Json groups;
  for (const game::ChainGroup& group : game::chain_groups()) {
    for (const auto& field : game::chain_count_fields())
      groups[std::string(group.name)][std::string(field.name)] = count_json(group.of(team), field);
  }
  return groups;
}

// {"pass": {"actions": 30, "worth": 0.2}, ...}
io::Json actions_json(const game::PlayCounts& team) {
  io::Json kinds;
  for (const Named<game::ActionKind>& kind : names_of(game::ActionKind{})) {
    for (const auto& field : game::action_count_fields())
      kinds[std::string(kind.name)][std::string(field.name)] =
          count_json(game::counts_of(team, kind.value), field);
  }
  return kinds;
}

}  // namespace

std::string end_text(const game::GameConfiguration& game, const game::GameRecord& record) {
  switch (record.end_reason) {
    case game::EndReason::kTime:
      return record.scene ? scene_end_text(record.scene->ended_by) : time_text(game);
    case game::EndReason::kGoals:
      return goals_text(game, record);
    case game::EndReason::kShootout:
      return shootout_text(game, record);
    case game::EndReason::kForfeitA:
    case game::EndReason::kForfeitB:
      return fmt::format("{} forfeited the game: {}",
                         team_text(game, record.end_reason == game::EndReason::kForfeitA),
                         record.void_reason);
    case game::EndReason::kVoid:
      return "the game is void: " + record.void_reason;
  }
  throw std::logic_error("unknown end of a game");
}

std::string json_of(const GameReport& report) {
  const game::GameRecord& record = report.record;
  const std::string changes = game::rule_changes_in(report.configuration);
  io::Json json = {
      {"goals_a", record.goals_a},
      {"goals_b", record.goals_b},
      {"goals_by_half", record.goals_by_half},
      {"end_reason", report.is_interrupted ? kInterrupted : name_of(record.end_reason)},
      {"shootout", record.shootout ? io::Json(*record.shootout) : io::Json()},
      {"status", name_of(record.status)},
      {"void_reason", record.void_reason.empty() ? io::Json() : io::Json(record.void_reason)},
      {"rules", report.configuration.match.rules.name},
      {"rule_changes", changes.empty() ? io::Json() : io::Json(changes)},
      {"seed", report.configuration.seed},
      {"teams", teams_json(report.configuration)},
      {"calls", calls_json(record)}};
  for (const game::GameTotal& one : game::game_totals()) json[one.name] = record.*one.count;
  for (const auto& field : game::count_fields()) add_counts(json, record, field);
  json["chains_a"] = chains_json(record.counts[0]);
  json["chains_b"] = chains_json(record.counts[1]);
  json["actions_a"] = actions_json(record.counts[0]);
  json["actions_b"] = actions_json(record.counts[1]);
  for (const game::MeasuredTime& time : game::measured_times())
    json[time.name] = record.*time.seconds;
  json.update({{"wall_s", report.wall_s},
               {"x_real_time", x_real_time(report)},
               {"state_hash", io::hash_text(record.state_hash)},
               {"build", report.build}});
  return io::json_text(json);
}

std::string text_of(const GameReport& report) {
  const game::GameConfiguration& game = report.configuration;
  const game::GameRecord& record = report.record;
  const Side a = game.match.a_plays;
  std::string text =
      fmt::format("a ({}, {})  {} : {}  b ({}, {})", game::name_of(game.a), name_of(a),
                  record.goals_a, record.goals_b, game::name_of(game.b), name_of(opponent_of(a)));
  if (!record.goals_by_half.empty()) text += fmt::format("   halves {}", halves_text(record));
  if (record.shootout) {
    text += fmt::format("   shoot-out {}:{}", (*record.shootout)[0], (*record.shootout)[1]);
  }
  const std::string rules = not_official_text(game::rule_changes_in(game));
  if (!rules.empty()) text += "\n" + rules;
  text += fmt::format("\nended: {}",
                      report.is_interrupted ? "the game was interrupted" : end_text(game, record));
  text += fmt::format("\ncalls: {}", calls_text(record));
  text += counts_text(record);
  text += fmt::format("\n{:.0f} s played, ball in play {:.0f} s; took {:.2f} s, {:.0f} x real time",
                      record.sim_s, record.ball_in_play_s, report.wall_s, x_real_time(report));
  return text +
         fmt::format("\nstate {}   build {}", io::hash_text(record.state_hash), report.build);
}

}  // namespace autoref::experiments
