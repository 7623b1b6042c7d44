// The record of a game: its result, how it ended and what happened in it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/loop/start_scene.hpp"
#include "game/play_counts/play_counts.hpp"
#include "referee/decision.hpp"
#include "soccer/named.hpp"

namespace autoref::game {

enum class EndReason : std::uint8_t { kTime, kGoals, kShootout, kForfeitA, kForfeitB, kVoid };

constexpr auto names_of(EndReason /*any*/) {
  return std::to_array<Named<EndReason>>({{EndReason::kTime, "time"},
                                          {EndReason::kGoals, "goals"},
                                          {EndReason::kShootout, "shootout"},
                                          {EndReason::kForfeitA, "forfeit_a"},
                                          {EndReason::kForfeitB, "forfeit_b"},
                                          {EndReason::kVoid, "void"}});
}

enum class Status : std::uint8_t { kOk, kForfeit, kVoid };

constexpr auto names_of(Status /*any*/) {
  return std::to_array<Named<Status>>(
      {{Status::kOk, "ok"}, {Status::kForfeit, "forfeit"}, {Status::kVoid, "void"}});
}

using autoref::name_of;

// Calls with a lower confidence are doubtful.
inline constexpr double kDoubtfulBelow = 0.7;

struct GameRecord {
  int goals_a = 0;
  int goals_b = 0;
  std::vector<std::array<int, 2>> goals_by_half;  // [a, b] of each half
  std::optional<std::array<int, 2>> shootout;     // [a, b] goals; nullopt without a shoot-out
  EndReason end_reason = EndReason::kTime;
  Status status = Status::kOk;
  std::string void_reason;                         // empty unless void or forfeited
  std::array<int, referee::kEventCount> events{};  // how often each event occurred
  int count(referee::Event event) const { return events[static_cast<std::size_t>(event)]; }
  int stops = 0;           // how often play was stopped, not counting the ends of halves
  int doubtful_calls = 0;  // calls with a confidence below kDoubtfulBelow
  // Labels of the transitions taken, without duplicates. The texts live as long as the program.
  std::vector<std::string_view> transitions;
  std::array<PlayCounts, 2> counts{};  // [a, b]
  std::optional<SceneRecord> scene;    // record of the scene, if the game was one
  double ball_in_play_s = 0;
  double sim_s = 0;
  std::int64_t frames = 0;
  std::uint64_t state_hash = 0;  // hash of every frame's state and every decision
  // Whether the game's programs sent the same commands when restarted; true without programs,
  // nullopt if that was not tried.
  std::optional<bool> is_repeatable = true;
  // Number of starts of the game's programs, which restart if they are killed from outside.
  int attempts = 1;
};

// A game that may have been interrupted before its end.
struct PlayedGame {
  GameRecord record;
  bool is_interrupted = false;  // `record` is then that of the frames so far
};

// A count of a game that belongs to neither an event nor a team, such as "stops".
struct GameTotal {
  std::string_view name;
  int GameRecord::*count;
};

// All such counts, in the order used in rows and JSON.
inline std::span<const GameTotal> game_totals() {
  static constexpr std::array kCounts = {GameTotal{"stops", &GameRecord::stops},
                                         GameTotal{"doubtful_calls", &GameRecord::doubtful_calls}};
  return kCounts;
}

// A time measured in a game, such as "sim_s".
struct MeasuredTime {
  std::string_view name;
  double GameRecord::*seconds;
};

// All measured times, in the order used in rows and JSON.
inline std::span<const MeasuredTime> measured_times() {
  static constexpr std::array kTimes = {MeasuredTime{"ball_in_play_s", &GameRecord::ball_in_play_s},
                                        MeasuredTime{"sim_s", &GameRecord::sim_s}};
  return kTimes;
}

}  // namespace autoref::game
