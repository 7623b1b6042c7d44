#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "io/json.hpp"
#include "io/table.hpp"
#include "logs/game_event_comparison.hpp"
#include "soccer/colour.hpp"

namespace autoref::logs {
namespace {

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
