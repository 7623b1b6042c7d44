// A plot that users can change and redraw: its data, its gnuplot script and the drawing made by
// gnuplot.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace autoref::experiments {

// `gnuplot NAME.gp` reads NAME.csv and draws NAME.svg.
struct Plot {
  std::string name;
  std::string about;  // a few sentences on what the plot shows and how to read it
  std::string csv;
  std::string script;
};

// Maximum number of groups with a row or a panel in a plot; more would be unreadable.
inline constexpr std::size_t kMostGroupsInPlot = 45;

inline constexpr std::size_t kLongestLabel = 34;  // characters; longer labels are cut

// Okabe and Ito's colours, which colour-blind people can distinguish.
inline constexpr const char* kBlue = "#0072b2";
inline constexpr const char* kVermilion = "#d55e00";

// The common beginning of all scripts: terminal, size in pixels, output file, data file (`data`),
// light axes. Text is drawn verbatim, without markup.
std::string script_head(std::string_view name, int height_px);

// The smallest of 1, 2 and 5 times a power of ten that divides the span into at most five parts.
double tic_step(double span);

// A note on groups left out of a plot; empty if it shows all of them.
std::string note_of_cut(std::size_t groups);

// `text` as a string literal of a script, without substitution or execution. Control characters
// become spaces.
std::string script_text(std::string_view text);

// Labelled tics of an axis ("x" or "y") at 1, 2, 3, ...; long labels are cut.
std::string script_tics(std::string_view axis, const std::vector<std::string>& labels);

// A complete script that draws one row per label: a point at the value in the data's column
// `mean_diff` and a bar from `low95` to `high95`. The column `row`, counted from 1, is the height
// of the row. `axis` is the label of the vertical axis, and
// `meaning` that of the horizontal one.
std::string interval_rows_script(std::string_view name, const std::vector<std::string>& labels,
                                 std::string_view axis, std::string_view meaning);

// Cuts a UTF-8 text to `letters` characters; if anything was cut, the last character is an
// ellipsis.
std::string shortened(const std::string& text, std::size_t letters);

// Time limit for drawing. If it takes longer, something is wrong.
inline constexpr double kLongestDrawing_s = 30;

struct Drawing {
  std::string svg;          // empty if drawing failed
  std::string trouble;      // why drawing failed, in one line
  bool is_missing = false;  // drawing failed because gnuplot is not installed
};

// Draws the plot in a temporary folder, with gnuplot's defaults instead of the user's settings, so
// the result does not depend on the user. Starts the gnuplot found in PATH, without a shell, and
// kills it after `longest_s`.
Drawing draw(const Plot& plot, double longest_s = kLongestDrawing_s);

}  // namespace autoref::experiments
