#include "experiments/scenes/continuation.hpp"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "experiments/analysis/groups.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/statistics/sample.hpp"
#include "referee/event.hpp"
#include "soccer/named.hpp"

namespace autoref::experiments {
namespace {

using game::SceneEnd;

// One of the members first_end and next_goal.
using FollowingMember = std::optional<FollowingEvent> Continuation::*;

FollowingEvent following_event(const referee::Decision& decision) {
  FollowingEvent event{decision.time_s, game::scene_end_by(decision.finding.event)};
  if (event.end == SceneEnd::kGoal) event.scorer = opponent_of(decision.finding.restart.side);
  return event;
}

io::Json colour_json(const std::optional<Side>& side) {
  return side ? io::Json(colour_of(*side)) : io::Json();
}

std::optional<Side> side_in(const io::Json& json) {
  if (json.is_null()) return std::nullopt;
  for (const Side side : kSides)
    if (json.get<std::string>() == colour_of(side)) return side;
  throw std::invalid_argument("unknown colour '" + json.get<std::string>() + "'");
}

io::Json following_json(const std::optional<FollowingEvent>& event) {
  if (!event) return {};
  return {{"after_s", event->after_s},
          {"end", name_of(event->end)},
          {"scorer", colour_json(event->scorer)}};
}

std::optional<FollowingEvent> following_in(const io::Json& json) {
  if (json.is_null()) return std::nullopt;
  return FollowingEvent{json.at("after_s").get<double>(),
                        find_named<SceneEnd>(json.at("end").get<std::string>()).value(),
                        side_in(json.at("scorer"))};
}

template <typename T>
io::Json by_colour(const PerSide<T>& values) {
  io::Json json = io::Json::object();
  for (const Side side : kSides) json[colour_of(side)] = values[side];
  return json;
}

// One of the ways in which games can continue.
struct Outcome {
  std::string label;  // in the text table
  io::Json key;       // the members that identify it in JSON
  std::function<bool(const Continuation&)> happened_in;
};

// The games with an outcome: a row of a table, and an object in JSON.
struct OutcomeRow {
  std::string label;
  io::Json key;
  ResultShare share;
  std::optional<double> median_s;     // nullopt without an event
  std::optional<std::uint64_t> seed;  // of the first such game; nullopt if there is none
};

struct OutcomeTable {
  std::string head;       // of the first column
  std::string json_name;  // the name of its rows in JSON
  bool has_times = true;
  std::vector<OutcomeRow> rows;
};

// Counts the games with this outcome, and takes the times of their events from `event`.
OutcomeRow outcome_row(const Outcome& outcome, const std::vector<Continuation>& games,
                       FollowingMember event) {
  OutcomeRow row{outcome.label, outcome.key, {0, static_cast<int>(games.size())}, {}, {}};
  std::vector<double> times_s;
  for (const Continuation& game : games) {
    if (!outcome.happened_in(game)) continue;
    ++row.share.part;
    if (!row.seed) row.seed = game.seed;
    if (event != nullptr && game.*event) times_s.push_back((game.*event)->after_s);
  }
  if (!times_s.empty()) row.median_s = median(times_s);
  return row;
}

OutcomeTable outcome_table(const std::string& head, const std::string& json_name,
                           const std::vector<Outcome>& outcomes,
                           const std::vector<Continuation>& games, FollowingMember event) {
  OutcomeTable table{head, json_name, event != nullptr, {}};
  for (const Outcome& outcome : outcomes) table.rows.push_back(outcome_row(outcome, games, event));
  return table;
}

Outcome first_end_outcome(const std::string& label, SceneEnd end, std::optional<Side> scorer = {}) {
  return {label,
          {{"end", name_of(end)}, {"scorer", colour_json(scorer)}},
          [end, scorer](const Continuation& game) {
            return game.first_end && game.first_end->end == end && game.first_end->scorer == scorer;
          }};
}

OutcomeTable play_ends_table(const std::vector<Continuation>& games,
                             const PerSide<std::string>& names, bool is_scene) {
  const auto goal = [&names](Side side) {
    return first_end_outcome("a goal by " + names[side], SceneEnd::kGoal, side);
  };
  const Outcome nothing{
      is_scene ? "nothing in that time" : "the end of the game",
      {{"end", is_scene ? name_of(SceneEnd::kTime) : "game_over"}, {"scorer", nullptr}},
      [](const Continuation& game) { return !game.first_end; }};
  OutcomeTable table = outcome_table(
      "play ends with", "play_ends",
      {goal(Side::kWest), goal(Side::kEast),
       first_end_outcome("the ball out of the field", SceneEnd::kBallOut),
       first_end_outcome("a foul", SceneEnd::kFoul),
       first_end_outcome("another stop, or the end of the half", SceneEnd::kStop), nothing},
      games, &Continuation::first_end);
  std::erase_if(table.rows, [](const OutcomeRow& row) {
    return row.share.part == 0 && row.key["end"] != name_of(SceneEnd::kGoal);
  });
  return table;
}

Outcome next_goal_outcome(const std::string& label, std::optional<Side> scorer) {
  return {label, {{"scorer", colour_json(scorer)}}, [scorer](const Continuation& game) {
            return (game.next_goal ? game.next_goal->scorer : std::nullopt) == scorer;
          }};
}

OutcomeTable next_goal_table(const std::vector<Continuation>& games,
                             const PerSide<std::string>& names) {
  return outcome_table(
      "next goal", "next_goal",
      {next_goal_outcome(names[Side::kWest], Side::kWest),
       next_goal_outcome(names[Side::kEast], Side::kEast), next_goal_outcome("none", std::nullopt)},
      games, &Continuation::next_goal);
}

Outcome result_outcome(const std::string& label, const std::string& key,
                       std::optional<Side> winner) {
  return {label, {{"result", key}}, [winner](const Continuation& game) {
            return game.winner == winner;
          }};
}

OutcomeTable results_table(const std::vector<Continuation>& games,
                           const PerSide<std::string>& names) {
  const auto win = [&names](Side side) {
    return result_outcome(names[side] + " wins", fmt::format("{}_wins", colour_of(side)), side);
  };
  return outcome_table(
      "result", "results",
      {win(Side::kWest), result_outcome("a draw", "draw", std::nullopt), win(Side::kEast)}, games,
      nullptr);
}

std::vector<OutcomeTable> outcome_tables(const std::vector<Continuation>& games,
                                         const PerSide<std::string>& names, bool is_scene) {
  std::vector<OutcomeTable> tables = {play_ends_table(games, names, is_scene)};
  if (is_scene) return tables;
  tables.push_back(next_goal_table(games, names));
  tables.push_back(results_table(games, names));
  return tables;
}

io::TextTable text_table_of(const OutcomeTable& table) {
  std::vector<std::string> columns = {table.head, kGamesHead, "share [95 %]"};
  if (table.has_times) columns.emplace_back("after [s]");
  columns.emplace_back("seed");
  io::TextTable text{{columns}, {io::Align::kLeft}};
  for (const OutcomeRow& row : table.rows) {
    std::vector<std::string> cells = {row.label, std::to_string(row.share.part),
                                      share_text(row.share.part, row.share.whole)};
    if (table.has_times) cells.push_back(row.median_s ? fmt::format("{:.1f}", *row.median_s) : "-");
    cells.push_back(row.seed ? std::to_string(*row.seed) : "-");
    text.rows.push_back(cells);
  }
  return text;
}

io::Json rows_json(const OutcomeTable& table) {
  io::Json rows = io::Json::array();
  for (const OutcomeRow& row : table.rows) {
    const auto& [low, high] = bounds_of(row.share.interval());
    io::Json json = row.key;
    json["games"] = row.share.part;
    json["share"] = io::json_number(row.share.fraction());
    json["low"] = io::json_number(low);
    json["high"] = io::json_number(high);
    if (table.has_times)
      json["median_s"] = row.median_s ? io::Json(io::rounded(*row.median_s, 3)) : io::Json();
    json["seed"] = row.seed ? io::Json(*row.seed) : io::Json();
    rows.push_back(json);
  }
  return rows;
}

std::vector<Continuation> without_void(std::vector<Continuation> games) {
  std::erase_if(games, [](const Continuation& game) { return !game.void_reason.empty(); });
  return games;
}

// The mean over games; nullopt if there are none.
PerSide<std::optional<double>> mean_goals_of(const std::vector<Continuation>& games) {
  PerSide<std::optional<double>> means;
  for (const Side side : kSides) {
    std::vector<double> goals;
    goals.reserve(games.size());
    for (const Continuation& game : games) goals.push_back(game.goals[side]);
    means[side] = mean_of(goals);
  }
  return means;
}

// "3 games were void: " and the first game's reason; empty if no game is void.
std::string void_line(const std::vector<Continuation>& games) {
  const std::size_t count = games.size() - without_void(games).size();
  for (const Continuation& game : games) {
    if (game.void_reason.empty()) continue;
    const char* subject = count == 1 ? "game was" : "games were";
    return fmt::format("{} {} void: {}\n", count, subject, game.void_reason);
  }
  return "";
}

}  // namespace

void ContinuationObserver::on_decision(const referee::Decision& decision) {
  if (decision.stage == Stage::kShootout) return;
  const bool ends_play =
      decision.from == referee::State::kRun && decision.to != referee::State::kRun;
  if (ends_play && !first_end_) first_end_ = following_event(decision);
  if (decision.finding.event == referee::Event::kGoal && !next_goal_)
    next_goal_ = following_event(decision);
}

Continuation ContinuationObserver::continuation(const game::GameConfiguration& game,
                                                const game::GameRecord& record) const {
  Continuation continuation{game.seed};
  if (is_void(record)) {
    continuation.void_reason = record.void_reason;
    return continuation;
  }
  const Side a = game.match.a_plays;
  continuation.first_end = first_end_;
  continuation.next_goal = next_goal_;
  continuation.goals[a] = record.goals_a;
  continuation.goals[opponent_of(a)] = record.goals_b;
  const double lead = lead_of_a(record);
  if (lead != 0) continuation.winner = lead > 0 ? a : opponent_of(a);
  return continuation;
}

io::Json json_of(const Continuation& continuation) {
  return {{"seed", continuation.seed},
          {"void_reason", continuation.void_reason},
          {"first_end", following_json(continuation.first_end)},
          {"next_goal", following_json(continuation.next_goal)},
          {"goals", by_colour(continuation.goals)},
          {"winner", colour_json(continuation.winner)}};
}

Continuation continuation_in(const io::Json& json) {
  Continuation continuation;
  continuation.seed = json.at("seed").get<std::uint64_t>();
  continuation.void_reason = json.at("void_reason").get<std::string>();
  continuation.first_end = following_in(json.at("first_end"));
  continuation.next_goal = following_in(json.at("next_goal"));
  for (const Side side : kSides)
    continuation.goals[side] = json.at("goals").at(std::string(colour_of(side))).get<int>();
  continuation.winner = side_in(json.at("winner"));
  return continuation;
}

io::TextBlocks continuations_table(const std::vector<Continuation>& games,
                                   const PerSide<std::string>& names, bool is_scene) {
  io::TextBlocks blocks;
  const std::vector<Continuation> completed = without_void(games);
  if (!completed.empty()) {
    for (const OutcomeTable& table : outcome_tables(completed, names, is_scene)) {
      if (!blocks.empty()) blocks.emplace_back("\n");
      blocks.emplace_back(text_table_of(table));
    }
    const PerSide<std::optional<double>> goals = mean_goals_of(completed);
    if (!is_scene)
      blocks.emplace_back(fmt::format("final score: {:.2f} : {:.2f} on average\n",
                                      *goals[Side::kWest], *goals[Side::kEast]));
  }
  if (const std::string line = void_line(games); !line.empty()) {
    if (!blocks.empty()) blocks.emplace_back("\n");
    blocks.emplace_back(line);
  }
  return blocks;
}

io::Json continuations_json(const std::vector<Continuation>& games,
                            const PerSide<std::string>& names, bool is_scene) {
  const std::vector<Continuation> completed = without_void(games);
  io::Json json = {{"teams", by_colour(names)},
                   {"games", games.size()},
                   {"void_games", games.size() - completed.size()}};
  for (const OutcomeTable& table : outcome_tables(completed, names, is_scene))
    json[table.json_name] = rows_json(table);
  if (!is_scene) {
    const PerSide<std::optional<double>> goals = mean_goals_of(completed);
    json["mean_goals"] = by_colour(PerSide<io::Json>{
        {io::json_number(goals[Side::kWest]), io::json_number(goals[Side::kEast])}});
  }
  json["each"] = io::Json::array();
  for (const Continuation& game : games) json["each"].push_back(json_of(game));
  return json;
}

}  // namespace autoref::experiments
