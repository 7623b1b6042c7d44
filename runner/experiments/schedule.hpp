// The list of a sweep's games, and what the schedules of other experiments share with it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

struct ScheduledGame {
  std::string id;                   // "b.handicap=0.8-p0007-2": values, pair, leg
  std::vector<std::string> values;  // of the factors, in the sweep's order, spelt
  int pair = 1;                     // counted from 1
  int leg = 1;                      // odd: team a in the west; even: team a in the east
  GameSettings configuration;
  std::string team_a = {};  // what rows call them: a sweep's by their strategies
  std::string team_b = {};
  std::size_t unit = 0;  // games of one unit go to the same shard: a pair's legs
};

// The games in the order in which they are played: both legs of a pair back to back, and pair by
// pair over all values, so that a run that is cut short is balanced.
//
// A game depends on its own values, pair and leg only: adding values or pairs changes no other
// game. Throws SettingError where values do not go together.
std::vector<ScheduledGame> scheduled_games(const Sweep& sweep);

// The games of games_of() (judge_schedule.hpp), whose values are the book and the camera.
std::vector<ScheduledGame> scheduled_games(const JudgeSchedule& schedule);

// "b.handicap=0.8-p0007-2" from what is played, the pair and the leg.
std::string game_id(std::string_view played, int pair, int leg);

// Sets what depends on the leg: who plays where, who kicks off first, and the seed. In both legs of
// a pair the same side kicks off first, west in odd pairs and east in even ones. So each team kicks
// off first in one leg of every pair, and over two pairs once from each side.
void set_leg(GameSettings& game, std::uint64_t master_seed, int pair, int leg);

// Throws SettingError where an experiment has more games than fit one; `key` is the setting that
// says how many.
void refuse_too_many(double games, std::string_view key = "pairs");

// The combinations of the factors' values, the last factor changing fastest.
std::vector<std::vector<SettingValue>> combinations(const std::vector<Factor>& factors);

// A game's seed, below 2^53 so that every program reads it exactly. It does not depend on the
// factors' values, so that the same pair has the same random numbers under each value.
std::uint64_t seed_of(std::uint64_t master_seed, int pair, int leg);

}  // namespace autoref::runner
