// Measures how the cost of a frame grows with the number of robots and cameras, and how it depends
// on the camera preset.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "benchmarks/measured_ratio.hpp"
#include "benchmarks/options.hpp"
#include "game/loop/game_configuration.hpp"

namespace autoref::benchmarks {

// One configuration of a series.
struct ScaledGame {
  std::string name;
  int units = 0;  // robots per side, or cameras; 0 in the series of presets
  game::GameConfiguration game;
};

struct ScaleSeries {
  std::string name;  // what varies from row to row
  std::string unit;  // "robot" or "camera"; empty in the series of presets
  std::vector<ScaledGame> games;
  std::size_t base = 0;  // the row that the others are compared with
};

// Robots per side, cameras, and camera presets.
std::vector<ScaleSeries> scale_series(const Options& options);

// One row of a table.
struct ScaleRow {
  std::string name;
  int units = 0;
  MeasuredRatio ratio;  // of the processor time per frame, to the same round's game of the base row
};

struct ScaleTable {
  std::string name;
  std::string unit;
  std::size_t base = 0;
  double base_ns_per_frame = 0;  // median of the rounds
  std::vector<ScaleRow> rows;

  // Factor that converts a row's ratio to that of the cost per unit. Only for series with units.
  double per_unit(const ScaleRow& row) const;
};

// How the cost per unit behaves beyond the base row. Of all rows with more units, the one with the
// highest cost per unit relative to the base row decides.
enum class Growth : std::uint8_t {
  kNotApplicable,  // no units, or no row beyond the base row
  kLinearOrBetter,
  kUndecided,    // above the base row, but the interval contains equality
  kSuperlinear,  // the whole interval is above the base row
};
Growth growth_of(const ScaleTable& table);

// `ns_per_frame` has one list per row of the series, with one value per round; at least
// kFewestRounds rounds.
ScaleTable scale_table(const ScaleSeries& series,
                       const std::vector<std::vector<double>>& ns_per_frame);

// Plays all games of all series in each round, alternately forwards and backwards, so that a
// slowdown of the machine affects all rows; prints a table of each series in Markdown. Throws
// std::logic_error if a game is void.
void print_frame_costs(const Options& options);

}  // namespace autoref::benchmarks
