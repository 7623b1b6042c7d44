#include "logs/game_event_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "referee/event.hpp"

namespace autoref::logs {
namespace {

double first_time_s(const GameEventPair& pair) {
  return pair.recorded ? pair.recorded->time_s : pair.refereed->time_s;
}

bool is_same(const GameEvent& a, const GameEvent& b) {
  return a.type == b.type && a.by_team == b.by_team;
}

// Decided by whoever commands the game.
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

}  // namespace autoref::logs
