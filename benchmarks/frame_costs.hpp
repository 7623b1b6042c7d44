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
  int units = 0;  // number of robots per side, or of cameras; 0 in the series of presets
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
  // Processor time per frame relative to that of the base row's game in the same round.
  MeasuredRatio ratio;
};

struct ScaleTable {
  std::string name;
  std::string unit;
  std::size_t base = 0;
  double base_ns_per_frame = 0;  // median of the rounds
  std::vector<ScaleRow> rows;

  // Factor that converts a row's ratio to the ratio of costs per unit. Only for series with units.
  double per_unit(const ScaleRow& row) const;
};

// How the cost per unit grows beyond the base row. The result is decided by the row with the
// highest cost per unit relative to the base row, among those with more units.
enum class Growth : std::uint8_t {
  kNotApplicable,  // no units, or no row beyond the base row
  kLinearOrBetter,
  kUndecided,    // the cost per unit is higher than in the base row, but the interval contains 1
  kSuperlinear,  // the whole interval is above 1
};
Growth growth_of(const ScaleTable& table);

// `ns_per_frame` has one list per row of the series, with one value per round. There must be at
// least kFewestRounds rounds.
ScaleTable scale_table(const ScaleSeries& series,
                       const std::vector<std::vector<double>>& ns_per_frame);

// Plays all games of all series in each round, alternately forwards and backwards, so that a
// slowdown of the machine affects all rows; prints a table of each series in Markdown. Throws
// std::logic_error if a game is void.
void print_frame_costs(const Options& options);

}  // namespace autoref::benchmarks
