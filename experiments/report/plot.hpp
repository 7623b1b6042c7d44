// A plot that users can change and redraw: data and a gnuplot script, and its drawing by gnuplot.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace autoref::experiments {

// `gnuplot NAME.gp` reads NAME.csv and draws NAME.svg.
struct Plot {
  std::string name;
  std::string about;  // a few sentences on what it shows and how to read it
  std::string csv;
  std::string script;
};

// Maximum number of groups with a row or a panel in a plot; more would be unreadable.
inline constexpr std::size_t kMostGroupsInPlot = 45;

inline constexpr std::size_t kLongestLabel = 34;  // characters; longer labels are cut

// Okabe and Ito's colours, which colour-blind people can tell apart.
inline constexpr const char* kBlue = "#0072b2";
inline constexpr const char* kVermilion = "#d55e00";

// Common head of all scripts: terminal, size in pixels, output file, data file (`data`), light
// axes. Text is drawn verbatim, without markup.
std::string script_head(std::string_view name, int height_px);

// The smallest of 1, 2 and 5 times a power of ten that divides the span into at most five parts.
double tic_step(double span);

// A note on groups that a plot leaves out; empty if it shows all.
std::string note_of_cut(std::size_t groups);

// `text` as a string literal of a script, without substitution or execution. Control characters
// become spaces.
std::string script_text(std::string_view text);

// Labelled tics of an axis ("x" or "y"), from 1; long labels are cut.
std::string script_tics(std::string_view axis, const std::vector<std::string>& labels);

// A whole script that draws a row per label: a point at the data's column `mean_diff` and a bar
// from `low95` to `high95`, at the height `row`, counted from 1. `axis` names the rows.
std::string interval_rows_script(std::string_view name, const std::vector<std::string>& labels,
                                 std::string_view axis, std::string_view meaning);

// Cuts a UTF-8 text to `letters` characters; the last is an ellipsis if something was cut.
std::string shortened(const std::string& text, std::size_t letters);

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
