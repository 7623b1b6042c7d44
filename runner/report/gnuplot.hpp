// Runs gnuplot on a plot.
#pragma once

#include <string>

#include "runner/report/plot.hpp"

namespace autoref::runner {

// No drawing takes longer unless something is wrong.
inline constexpr double kLongestDrawing_s = 30;

struct Drawing {
  std::string svg;          // empty where it could not be drawn
  std::string trouble;      // why not, in one line
  bool is_missing = false;  // gnuplot is not installed
};

// Draws in a temporary folder of its own, with gnuplot's own settings instead of the user's, so
// that a plot comes out the same for everybody. gnuplot is looked for in PATH and started without a
// shell; it is ended after `longest_s`.
Drawing draw(const Plot& plot, double longest_s = kLongestDrawing_s);

}  // namespace autoref::runner
