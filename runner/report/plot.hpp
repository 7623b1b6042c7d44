// A plot as a user may change and redraw it: numbers, and the gnuplot script that draws them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace autoref::runner {

// `gnuplot NAME.gp` beside NAME.csv draws NAME.svg.
struct Plot {
  std::string name;
  std::string about;  // what it shows and how to read it, a few sentences
  std::string csv;
  std::string script;
};

// Groups that have a row or a panel in a plot; a plot of more would not be read.
inline constexpr std::size_t kMostGroupsInPlot = 45;

inline constexpr std::size_t kLongestLabel = 34;  // letters; longer ones are cut

// Okabe's and Ito's colours, which colour-blind people can tell apart.
inline constexpr const char* kBlue = "#0072b2";
inline constexpr const char* kVermilion = "#d55e00";

// What every script begins with: the terminal, its size in pixels, the file it draws, the name of
// its data (`data`), light axes. Text is drawn letter by letter, without markup.
std::string script_head(std::string_view name, int height_px);

// The least of 1, 2 and 5 times powers of ten that divides a span into five parts or fewer.
double tic_step(double span);

// What a plot says of groups that it has no place for; empty where it shows all.
std::string note_of_cut(std::size_t groups);

// `text` as a string of a script, in which nothing is replaced or carried out. Control characters
// become spaces.
std::string script_text(std::string_view text);

// The tics of the axis ("x", "y"), labelled, from 1 on; long labels are cut.
std::string script_tics(std::string_view axis, const std::vector<std::string>& labels);

// At most `letters` of UTF-8, the last one an ellipsis where some are missing.
std::string shortened(const std::string& text, std::size_t letters);

}  // namespace autoref::runner
