// Measures how the cost of a frame grows with the robots, the cameras and the camera preset.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runner/bench/bench_rounds.hpp"
#include "runner/bench/fixed_games.hpp"
#include "runner/statistics/interval.hpp"

namespace autoref::runner {

struct ScaleOptions {
  FixedTeams teams = FixedTeams::kPlain;
  int rounds = kDefaultRounds;  // at least kFewestRounds
  double half_s = 60;           // duration of each half of a game
};

// One configuration of a series.
struct ScaledGame {
  std::string name;
  int units = 0;  // robots per side, or cameras; 0 in a series of presets
  GameConfiguration game;
};

struct ScaleSeries {
  std::string name;  // what changes from row to row
  std::string unit;  // "robot" or "camera"; empty in a series of presets
  std::vector<ScaledGame> games;
  std::size_t base = 0;  // the row that the others are compared with
};

// The series of `autoref bench --scale`.
std::vector<ScaleSeries> scale_series(const ScaleOptions& options);

// Ratio to the same round's game of the base row: median of the rounds and its interval
// (statistics/median_interval.hpp).
struct ScaleRow {
  std::string name;
  int units = 0;
  double ratio = 1;  // of the processor time per frame
  Interval interval{1, 1};
};

struct ScaleTable {
  std::string name;
  std::string unit;
  std::size_t base = 0;
  double base_ns_per_frame = 0;  // median of the rounds
  std::vector<ScaleRow> rows;

  // Factor that turns a row's ratio into that of the cost per unit. Only in a series with units.
  double per_unit(const ScaleRow& row) const;
};

// How the cost per unit behaves beyond the base row: of all rows with more units, the one in which
// it is highest relative to the base row decides.
enum class Growth : std::uint8_t {
  kNotApplicable,  // no units, or no row beyond the base row
  kLinearOrBetter,
  kUndecided,    // above the base row, but the interval contains equality
  kSuperlinear,  // above the base row, as is the whole interval
};
Growth growth_of(const ScaleTable& table);

// `ns_per_frame` has one list per row of the series, with one value per round, at least
// kFewestRounds.
ScaleTable scale_table(const ScaleSeries& series,
                       const std::vector<std::vector<double>>& ns_per_frame);

// Plays all games of all series in each round, alternately forwards and backwards, so that a
// slowdown of the machine affects all rows. Throws std::logic_error if a game is void.
std::vector<ScaleTable> bench_scale(const ScaleOptions& options);

std::string scale_json(const std::vector<ScaleTable>& tables);
std::string scale_markdown(const std::vector<ScaleTable>& tables, const ScaleOptions& options);

// Runs the verb: prints the tables to stdout in Markdown, with `json` as one JSON object. Returns
// the exit code.
int run_scale_bench(const ScaleOptions& options, bool json);

}  // namespace autoref::runner
