// Runs gnuplot to draw a plot.
#pragma once

#include <string>

#include "experiments/report/plot.hpp"

namespace autoref::experiments {

// Drawing takes longer only if something is wrong.
inline constexpr double kLongestDrawing_s = 30;

struct Drawing {
  std::string svg;          // empty if drawing failed
  std::string trouble;      // why it failed, in one line
  bool is_missing = false;  // gnuplot is not installed
};

// Draws in a temporary folder, with gnuplot's defaults instead of the user's settings, so the
// result is the same for everybody. gnuplot is searched for in PATH, started without a shell, and
// killed after `longest_s`.
Drawing draw(const Plot& plot, double longest_s = kLongestDrawing_s);

}  // namespace autoref::experiments
