// The games of an experiment, their settings and their order, and helpers for the schedules of all
// kinds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "game/settings/game_settings.hpp"

namespace autoref::experiments {

// The settings in which the games of two teams differ: the teams' sides, the first kick-off and the
// seed.
struct LegSettings {
  Side a_plays = Side::kWest;
  Side first_kickoff = Side::kWest;
  std::uint64_t seed = 42;
};

// The settings of one of many games, most of which it shares with the others. An experiment has up
// to 100,000 games but few different settings: a game's full settings take 4.5 kB or more, and this
// object about 0.1 kB. Copies share their parts.
class SharedSettings {
 public:
  // Takes the settings as they are. This object does not record which settings were given
  // explicitly, since presets have already been applied.
  explicit SharedSettings(game::GameSettings game);

  // The same game with other teams, another leg, or another start of a scene. The start is given
  // with team a in the west and is rotated if team a plays in the east.
  SharedSettings between(std::shared_ptr<const game::TeamSettings> a,
                         std::shared_ptr<const game::TeamSettings> b) const;
  SharedSettings with(const LegSettings& leg) const;
  SharedSettings starting_from(std::shared_ptr<const game::StartState> start) const;

  const LegSettings& leg() const { return leg_; }
  const game::TeamSettings& a() const { return *a_; }
  const game::TeamSettings& b() const { return *b_; }

  // All settings of the game.
  game::GameSettings combined() const;

 private:
  std::shared_ptr<const game::GameSettings> base_;
  std::shared_ptr<const game::TeamSettings> a_;
  std::shared_ptr<const game::TeamSettings> b_;
  // Start with team a in the west; null: that of the base.
  std::shared_ptr<const game::StartState> start_;
  LegSettings leg_;
};

inline constexpr int kMostPairs = 9999;  // maximum number of pairs of legs

struct ScheduledGame {
  std::string id;                   // "b.handicap=0.8-p0007-2": values, pair, leg
  std::vector<std::string> values;  // text of the factors' values, in the sweep's order
  int pair = 1;                     // counted from 1
  int leg = 1;                      // odd: team a in the west; even: team a in the east
  SharedSettings settings;
  std::string team_a = {};  // the team's name in result rows; its strategy or program in a sweep
  std::string team_b = {};
  // Number of the unit; games of one unit, such as a pair's legs, are played by the same shard.
  std::size_t unit = 0;
  // Index of the game's values or matchup in the order of summary.csv, and the number of values or
  // matchups that take turns. Each of them plays again after that number of units, and its games
  // are shared evenly among the shards. The number is 0 if they do not take turns, as in a
  // knockout, a tuning or judged games.
  std::size_t variant = 0;
  std::size_t variants = 0;
};

// The game's configuration, with its id.
game::GameConfiguration resolved(const ScheduledGame& game);

// The id of a game: "b.handicap=0.8-p0007-2" if `played` is "b.handicap=0.8", for pair 7 and leg 2.
std::string game_id(std::string_view played, int pair, int leg);

// Throws SettingError for a team that is commanded over the network, since only `autoref live`
// plays such teams. `path` is the path of the team in the scenario.
void refuse_network(const game::TeamSettings& team, std::string_view path);

// Throws SettingError if a game controller commands the games, since only `autoref play` supports
// that.
void refuse_game_controller(const game::GameSettings& game);

// The settings that depend on the leg. In both legs of a pair, the same side kicks off first: west
// in odd pairs, east in even pairs. So each team kicks off first in one leg of every pair, and once
// from each side over two pairs.
LegSettings leg_of(std::uint64_t master_seed, int pair, int leg);

// Throws SettingError if there are too many games for one experiment; `key` is the setting that the
// error names.
void refuse_too_many(double games, std::string_view key = "pairs");

// A game's seed, below 2^53 so that programs that read numbers as doubles get it exactly. It does
// not depend on the factors' values: games with different values but the same pair number share
// their random numbers, so they can be compared in pairs.
std::uint64_t seed_of(std::uint64_t master_seed, int pair, int leg);

// The games of several variants that take turns: for each pair number, both legs of every variant
// in the order `order`. `make(variant, pair, leg)` returns a game without its unit.
std::vector<ScheduledGame> games_in_turns(
    const std::vector<std::size_t>& order, int pairs,
    const std::function<ScheduledGame(std::size_t variant, int pair, int leg)>& make);

// The order in which an experiment plays its matchups or combinations of values. At any time, every
// team and every value has been played about equally often.

// The matchups of a round robin as indices into matchups_among(). After any number of
// matchups, the numbers of matchups that two teams have played differ by at most one.
//
// An even number of teams plays in the rounds of the circle method: one team stays in place, the
// others move around a circle, and every team plays once per round. With an odd number, one team
// would sit out each round and fall behind. In that case, the matchups are Walecki's Hamiltonian
// cycles through all teams (B. Alspach, "The wonderful Walecki construction", Bulletin of the ICA
// 52, 2008), in each of which every team plays twice: first every other matchup along the cycle,
// then the rest.
std::vector<std::size_t> round_robin_order(std::size_t teams);

// The combinations of several lists' values as indices into all combinations in which the last list
// changes fastest. `sizes` are the lists' lengths, at least 1. After any number of combinations,
// any two values of a list have occurred equally often or differ by one occurrence.
std::vector<std::size_t> combinations_order(const std::vector<std::size_t>& sizes);

}  // namespace autoref::experiments
