#include "experiments/report/plot.hpp"

#include <fmt/format.h>

#include <cmath>

namespace autoref::experiments {
namespace {

constexpr int kPlotWidth_px = 800;
constexpr int kIntervalRowHeight_px = 26;
constexpr int kIntervalFrameHeight_px = 90;

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

std::string script_head(std::string_view name, int height_px) {
  return fmt::format(
      "# Draws {0}.svg from {0}.csv: gnuplot {0}.gp\n"
      "reset\n"
      "set encoding utf8\n"
      "set terminal svg noenhanced size {1},{2} font 'Helvetica,13' background 'white' name '{0}'\n"
      "set output '{0}.svg'\n"
      "set datafile separator ','\n"
      "set datafile columnheaders\n"
      "data = '{0}.csv'\n"
      "set border 3 lc rgb '#777777'\n"
      "set tics nomirror out\n"
      "set grid lc rgb '#e4e4e4' lt 1 lw 1\n",
      name, kPlotWidth_px, height_px);
}

double tic_step(double span) {
  // Multiplying by these factors in turn gives 2, 5 and 10 times the power of ten.
  double step = std::pow(10.0, std::floor(std::log10(span / 5)));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (span / step > 5) step *= factor;
  }
  return step;
}

std::string note_of_cut(std::size_t groups) {
  if (groups <= kMostGroupsInPlot) return "";
  return fmt::format(" Only the first {} of {} are drawn; the data file contains all.",
                     kMostGroupsInPlot, groups);
}

std::string script_text(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    // In gnuplot's single quotes nothing is special except the quote itself, which is doubled.
    if (c == '\'') quoted += '\'';
    quoted += is_control(c) ? ' ' : c;
  }
  return quoted + "'";
}

std::string script_tics(std::string_view axis, const std::vector<std::string>& labels) {
  std::vector<std::string> tics;
  tics.reserve(labels.size());
  for (const std::string& label : labels) {
    tics.push_back(
        fmt::format("{} {}", script_text(shortened(label, kLongestLabel)), tics.size() + 1));
  }
  return fmt::format("set {}tics ({})\n", axis, fmt::join(tics, ", "));
}

std::string shortened(const std::string& text, std::size_t letters) {
  std::size_t count = 0;
  std::size_t cut = 0;  // end of the last character that fits before an ellipsis
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!begins_letter(text[i])) continue;
    if (++count == letters) cut = i;
  }
  return count <= letters ? text : text.substr(0, cut) + "…";
}

std::string interval_rows_script(std::string_view name, const std::vector<std::string>& labels,
                                 std::string_view axis, std::string_view meaning) {
  const int rows = static_cast<int>(labels.size());
  return script_head(name, kIntervalFrameHeight_px + kIntervalRowHeight_px * rows) +
         script_tics("y", labels) +
         fmt::format(
             "set ylabel {0}\n"
             "set yrange [{1}.6:0.4]\n"
             "set xlabel {2}\n"
             "set xrange [*<0:0<*]\n"
             "set arrow from first 0, graph 0 to first 0, graph 1 nohead lc rgb '#777777' dt 2\n"
             "plot data using 'mean_diff':'row':'low95':'high95' with xerrorbars pt -1 lw 2 lc rgb "
             "'{3}' notitle, \\\n"
             "     data using 'mean_diff':'row' with points pt 7 ps 0.6 lc rgb '{3}' notitle\n",
             script_text(axis), rows, script_text(meaning), kBlue);
}

}  // namespace autoref::experiments
