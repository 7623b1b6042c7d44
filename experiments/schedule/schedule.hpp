// The games of an experiment, and helpers that the schedules of all kinds share.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/schedule/shared_settings.hpp"

namespace autoref::experiments {

inline constexpr int kMostPairs = 9999;  // pairs of legs

struct ScheduledGame {
  std::string id;                   // "b.handicap=0.8-p0007-2": values, pair, leg
  std::vector<std::string> values;  // text of the factors' values, in the sweep's order
  int pair = 1;                     // counted from 1
  int leg = 1;                      // odd: team a in the west; even: team a in the east
  SharedSettings settings;
  std::string team_a = {};  // the team's name in result rows; its strategy or program in a sweep
  std::string team_b = {};
  std::size_t unit = 0;  // games of one unit, such as a pair's legs, go to the same shard
  // Number of its values or matchup, in the order of summary.csv, and how many of them take turns:
  // so many units after it, they play again, and shards share their games evenly. 0 if they do not
  // take turns: in a knockout, a tuning and judged games.
  std::size_t variant = 0;
  std::size_t variants = 0;
};

// The game's configuration, with its id.
game::GameConfiguration resolved(const ScheduledGame& game);

// The id of a game: "b.handicap=0.8-p0007-2" if `played` is "b.handicap=0.8", for pair 7 and leg 2.
std::string game_id(std::string_view played, int pair, int leg);

// Throws SettingError for a team that is commanded over the network: only `autoref live` plays
// those. `path` is the team's in the scenario.
void refuse_network(const game::TeamSettings& team, std::string_view path);

// Throws SettingError if a game controller commands the games: only `autoref play` has one.
void refuse_game_controller(const game::GameSettings& game);

// What depends on the leg. In both legs of a pair, the same side kicks off first: west in odd
// pairs, east in even pairs. So each team kicks off first in one leg of every pair, and once from
// each side over two pairs.
LegSettings leg_of(std::uint64_t master_seed, int pair, int leg);

// Throws SettingError if there are too many games for one experiment; `key` is the setting to
// blame.
void refuse_too_many(double games, std::string_view key = "pairs");

// A game's seed, below 2^53 so that programs that read numbers as doubles get it exactly. It does
// not depend on the factors' values: games with different values but the same pair number share
// their random numbers, so they can be compared in pairs.
std::uint64_t seed_of(std::uint64_t master_seed, int pair, int leg);

}  // namespace autoref::experiments
