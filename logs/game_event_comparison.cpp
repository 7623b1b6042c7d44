#include "logs/game_event_comparison.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/json.hpp"
#include "io/table.hpp"
#include "referee/event.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {
namespace {

double first_time_s(const GameEventPair& pair) {
  return pair.recorded ? pair.recorded->time_s : pair.refereed->time_s;
}

bool is_same(const GameEvent& a, const GameEvent& b) {
  return a.type == b.type && a.by_team == b.by_team;
}

// Events decided by whoever commands the game.
bool is_persons(GameEventType type) {
  return type == GameEventType::kPlacementSucceeded || type == GameEventType::kPlacementFailed ||
         type == GameEventType::kMultipleFouls || type == GameEventType::kMultipleCards;
}

// The first free event that fits, or the end.
std::size_t match_of(const game::TimedGameEvent& recorded,
                     std::span<const game::TimedGameEvent> refereed,
                     const std::vector<bool>& is_taken, double tolerance_s) {
  for (std::size_t i = 0; i < refereed.size(); ++i) {
    const bool is_near = std::abs(refereed[i].time_s - recorded.time_s) <= tolerance_s;
    if (is_near && !is_taken[i] && is_same(recorded.event, refereed[i].event)) return i;
  }
  return refereed.size();
}

void count(GameEventComparison& comparison, const GameEventPair& pair) {
  const game::TimedGameEvent& either = pair.recorded ? *pair.recorded : *pair.refereed;
  for (GameEventCounts* counts : {&comparison.types[either.event.type], &comparison.all}) {
    counts->recorded += pair.recorded ? 1 : 0;
    counts->refereed += pair.refereed ? 1 : 0;
    counts->matched += pair.is_matched() ? 1 : 0;
  }
}

bool has_recorded(const GameEventComparison& comparison) {
  return comparison.all.recorded > 0 || !comparison.not_judged.empty();
}

// Types of later editions have only a number.
std::string title_of(GameEventType type) {
  const std::string_view name = name_of(type);
  return name.empty() ? std::to_string(static_cast<int>(type)) : std::string(name);
}

std::vector<std::string> table_row(const std::string& title, const GameEventCounts& counts) {
  return {title, std::to_string(counts.recorded), std::to_string(counts.refereed),
          std::to_string(counts.matched)};
}

std::string list_of(const std::map<GameEventType, int>& types) {
  std::string list;
  for (const auto& [type, count] : types)
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, title_of(type));
  return list.empty() ? "none" : list;
}

io::Json time_or_null(const std::optional<game::TimedGameEvent>& event) {
  return event ? io::Json(event->time_s) : io::Json();
}

io::Json pair_json(const GameEventPair& pair) {
  const GameEvent& event = pair.recorded ? pair.recorded->event : pair.refereed->event;
  return {{"type", title_of(event.type)},
          {"side", event.by_team ? io::Json(colour_of(*event.by_team)) : io::Json()},
          {"recorded_s", time_or_null(pair.recorded)},
          {"autoref_s", time_or_null(pair.refereed)}};
}

io::Json counts_json(const GameEventCounts& counts) {
  return {{"recorded", counts.recorded}, {"judged", counts.refereed}, {"right", counts.matched}};
}

}  // namespace

bool is_judged(GameEventType type, referee::Control control) {
  if (control != referee::Control::kAutoref && is_persons(type)) return false;
  const std::string_view name = name_of(type);
  const auto table = referee::event_table();
  return !name.empty() && std::any_of(table.begin(), table.end(), [&](const auto& entry) {
    return entry.league_event == name;
  });
}

GameEventComparison compared(std::span<const game::TimedGameEvent> recorded,
                             std::span<const game::TimedGameEvent> refereed,
                             referee::Control control, double tolerance_s) {
  GameEventComparison comparison;
  std::vector<bool> is_taken(refereed.size(), false);
  for (const game::TimedGameEvent& event : recorded) {
    if (!is_judged(event.event.type, control)) {
      ++comparison.not_judged[event.event.type];
      continue;
    }
    GameEventPair& pair = comparison.pairs.emplace_back(GameEventPair{event, std::nullopt});
    const std::size_t match = match_of(event, refereed, is_taken, tolerance_s);
    if (match == refereed.size()) continue;
    is_taken[match] = true;
    pair.refereed = refereed[match];
  }
  for (std::size_t i = 0; i < refereed.size(); ++i) {
    if (!is_taken[i]) comparison.pairs.push_back({std::nullopt, refereed[i]});
  }
  std::stable_sort(comparison.pairs.begin(), comparison.pairs.end(),
                   [](const GameEventPair& a, const GameEventPair& b) {
                     return first_time_s(a) < first_time_s(b);
                   });
  for (const GameEventPair& pair : comparison.pairs) count(comparison, pair);
  return comparison;
}

std::string game_events_text(const GameEventComparison& comparison, std::string_view other) {
  if (!has_recorded(comparison)) return "";
  std::vector<std::vector<std::string>> rows = {
      {"game event", std::string(other), "AutoRef", "matched"}};
  for (const auto& [type, counts] : comparison.types)
    rows.push_back(table_row(title_of(type), counts));
  rows.push_back(table_row("all", comparison.all));
  return fmt::format("\n{}not judged  {}\n",
                     io::aligned(rows, {io::Align::kLeft, io::Align::kRight, io::Align::kRight,
                                        io::Align::kRight}),
                     list_of(comparison.not_judged));
}

io::Json game_events_json(const GameEventComparison& comparison) {
  if (!has_recorded(comparison)) return {};
  io::Json types = io::Json::array();
  for (const auto& [type, counts] : comparison.types) {
    io::Json row = {{"type", title_of(type)}};
    row.update(counts_json(counts));
    types.push_back(std::move(row));
  }
  io::Json pairs = io::Json::array();
  for (const GameEventPair& pair : comparison.pairs) pairs.push_back(pair_json(pair));
  io::Json not_judged = io::Json::array();
  for (const auto& [type, count] : comparison.not_judged)
    not_judged.push_back({{"type", title_of(type)}, {"recorded", count}});
  io::Json json = counts_json(comparison.all);
  json["types"] = std::move(types);
  json["events"] = std::move(pairs);
  json["not_judged"] = std::move(not_judged);
  return json;
}

}  // namespace autoref::logs
