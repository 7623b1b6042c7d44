// One game of an experiment: what was played, how it ended, and on which machine.
//
// Rows are passed around as structs. Their only text form is a line of a shard (row_format.hpp).
// The worker that played a game writes this line, and the main process appends it to the shard
// unchanged.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/results/call_evaluation.hpp"
#include "experiments/schedule/schedule.hpp"
#include "game/loop/game.hpp"

namespace autoref::experiments {

// Where and how the game was played. This can differ from run to run.
struct Circumstances {
  std::string build;
  std::string host;
  std::string cpu;
  double wall_s = 0;
  int attempt = 1;
  std::string shard = "0/1";
};

struct GameRow {
  std::string game_id;  // "b.handicap=0.8-p0007-2"
  int pair = 1;         // counted from 1
  int leg = 1;
  std::vector<std::string> values;  // values of the factors, as spelt() writes them
  std::string team_a;
  std::string team_b;
  Side side_a = Side::kWest;  // side on which team a played the first half
  std::uint64_t seed = 0;
  std::string rule_changes;  // text_of() the game's changes (soccer/rules/rule_changes.hpp)

  // A record read from a file contains only what the columns store: the events that are calls, the
  // goals of the first half, and times rounded to milliseconds. The
  // record of a judged game contains only the status, the reason, the transitions and the hash.
  game::GameRecord record;
  CallEvaluation evaluation;  // the calls of a judged game

  std::uint64_t config_hash = 0;
  Circumstances circumstances;
};

using RowsById = std::map<std::string, GameRow>;

// Rows as in files: a game can have several rows, which keep their order. Moving a row to RowsById
// moves its node, without another allocation.
using RowsInFiles = std::multimap<std::string, GameRow>;

// One line for each list of changes in the rows: "40 of 80 games: not the official rules: double
// touch 150 mm (50)"; without the numbers of games if it concerns all rows.
std::vector<std::string> rule_notes(const RowsById& rows);

// The row for a scheduled game that has not been played.
GameRow row_of(const ScheduledGame& game);

// The record for a void game, with the reason why it could not be completed.
game::GameRecord void_record(const std::string& reason);

bool is_void(const game::GameRecord& record);

// Positive if team a won, negative if team b won, and 0 for a draw. Goals decide, or the shoot-out
// if there was one. A team that forfeits has lost, regardless of the score. The value has no
// meaning for void games.
double lead_of_a(const game::GameRecord& record);

// "3:1", "1:1 (4:2)" with a shoot-out, "void".
std::string score_text(const game::GameRecord& record);

}  // namespace autoref::experiments
