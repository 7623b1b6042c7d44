#include "experiments/report/running_mean.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "experiments/report/group_names.hpp"
#include "experiments/report/plots.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {
namespace {

constexpr double kMeanMargin = 0.05;   // fraction of the span, above and below
constexpr std::size_t kWildPairs = 5;  // intervals of the first pairs may leave the axis

constexpr std::size_t kLongestTitle = 26;  // maximum number of characters
constexpr double kTop_px = 62;             // space above the top panel
constexpr double kMeansBottom_px = 44;     // space below the bottom panel
constexpr double kBetween_px = 66;         // space between panels

struct Panel {
  std::string name;
  std::vector<RunningMean> means;
};

// Number of panels in a row, number of rows, and height of the frame.
struct Layout {
  int columns = 1;
  int rows = 1;
  int height_px = 0;
};

Layout layout_for(int panels) {
  const int columns = panels <= 1 ? 1 : panels <= 4 ? 2 : panels <= 15 ? 3 : 4;
  const int rows = (panels + columns - 1) / columns;
  const int height_px = columns == 1 ? 260 : columns == 2 ? 170 : 110;
  return {
      columns, rows,
      static_cast<int>(kTop_px + kMeansBottom_px + (rows - 1) * kBetween_px) + rows * height_px};
}

std::vector<Panel> panels_of(const Scenario& scenario, const std::vector<Group>& groups) {
  const std::vector<std::string> names = names_of(scenario, groups);
  const bool has_one_factor = scenario.experiment().value_columns().size() == 1;
  const std::string prefix = has_one_factor ? axis_name(scenario) + " " : "";
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Panel panel{prefix + names[i], running_means(groups[i])};
    if (!panel.means.empty()) panels.push_back(std::move(panel));
  }
  return panels;
}

std::string csv_of(const std::vector<Panel>& panels) {
  std::string csv = "panel,name,pairs,mean_diff,low95,high95\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    for (std::size_t n = 0; n < panels[i].means.size(); ++n) {
      const auto& [low, high] = bounds_of(panels[i].means[n].interval);
      csv += io::csv_line({std::to_string(i + 1), panels[i].name, std::to_string(n + 1),
                           io::number_cell(panels[i].means[n].mean), io::number_cell(low),
                           io::number_cell(high)}) +
             "\n";
    }
  }
  return csv;
}

// Script line for an array of each panel's `value`.
template <typename Value>
std::string array_of(const char* name, const std::vector<Panel>& panels, const Value& value) {
  std::vector<std::string> values;
  values.reserve(panels.size());
  for (const Panel& panel : panels) values.push_back(value(panel));
  return fmt::format("array {}[{}] = [{}]\n", name, values.size(), fmt::join(values, ", "));
}

double last_pair(const Panel& panel) {
  return static_cast<double>(std::max<std::size_t>(panel.means.size(), 2));
}

std::string arrays_of(const std::vector<Panel>& panels) {
  const auto name = [](const Panel& panel) {
    return script_text(shortened(panel.name, kLongestTitle));
  };
  const auto pairs = [](const Panel& panel) { return fmt::format("{}", last_pair(panel)); };
  const auto low = [](const Panel& panel) {
    return io::number_cell(span_to_show(panel.means).low);
  };
  const auto high = [](const Panel& panel) {
    return io::number_cell(span_to_show(panel.means).high);
  };
  const auto x_step = [](const Panel& panel) {
    return fmt::format("{}", std::max(1.0, tic_step(last_pair(panel))));
  };
  const auto y_step = [](const Panel& panel) {
    const auto [from, to] = span_to_show(panel.means);
    return fmt::format("{:.6g}", tic_step(to - from));
  };
  return array_of("name", panels, name) + array_of("pairs", panels, pairs) +
         array_of("low", panels, low) + array_of("high", panels, high) +
         array_of("x_step", panels, x_step) + array_of("y_step", panels, y_step);
}

// Position of the panels in the frame.
std::string frame_of(const Layout& layout) {
  const double height = layout.height_px;
  return fmt::format(
      "set multiplot layout {},{} margins screen 0.07,0.985,{:.4f},{:.4f} spacing screen "
      "0.075,{:.4f} title 'goals of a minus goals of b by number of pairs of legs, 95 % interval: "
      "not for stopping early' font ',13'\n",
      layout.rows, layout.columns, kMeansBottom_px / height, 1 - kTop_px / height,
      kBetween_px / height);
}

std::string script_of(const std::vector<Panel>& panels) {
  const Layout layout = layout_for(static_cast<int>(panels.size()));
  return script_head("running_mean", layout.height_px) + arrays_of(panels) +
         "set title font ',13' offset 0,-0.7\n"
         "set tics font ',11'\n"
         "of(i, column_name) = column('panel') == i ? column(column_name) : NaN\n" +
         frame_of(layout) +
         fmt::format(
             "do for [i=1:{0}] {{\n"
             "  set title name[i]\n"
             "  set xrange [1:pairs[i]]\n"
             "  set yrange [low[i]:high[i]]\n"
             "  set xtics x_step[i] offset 0,0.4\n"
             "  set ytics y_step[i]\n"
             "  plot data using (of(i, 'pairs')):(of(i, 'low95')):(of(i, 'high95')) with "
             "filledcurves lc rgb '{1}' fs transparent solid 0.18 notitle, \\\n"
             "       0 with lines lc rgb '#777777' dt 2 notitle, \\\n"
             "       data using (of(i, 'pairs')):(of(i, 'mean_diff')) with lines lw 2 lc rgb '{1}' "
             "notitle\n"
             "}}\n"
             "unset multiplot\n",
             panels.size(), kBlue);
}

}  // namespace

std::vector<RunningMean> running_means(const Group& group) {
  const std::vector<double> values = values_of(group.pair_differences);
  std::vector<RunningMean> means;
  for (std::size_t n = 1; n <= values.size(); ++n) {
    const std::span<const double> first(values.data(), n);
    means.push_back({mean(first), mean_interval(first)});
  }
  return means;
}

Interval span_to_show(const std::vector<RunningMean>& means) {
  Interval span;
  const auto include = [&span](double value) {
    span = {std::min(span.low, value), std::max(span.high, value)};
  };
  const std::size_t wild = std::min(kWildPairs, means.size() - 1);
  for (std::size_t i = 0; i < means.size(); ++i) {
    include(means[i].mean);
    // With few pairs, Student's interval is so wide that it would flatten the rest of the curve.
    if (i < wild || !means[i].interval) continue;
    include(means[i].interval->low);
    include(means[i].interval->high);
  }
  const double width = span.high > span.low ? span.high - span.low : 1;
  return {span.low - kMeanMargin * width, span.high + kMeanMargin * width};
}

std::optional<Plot> running_mean_plot(const Scenario& scenario, const ExperimentResults& results) {
  std::vector<Panel> panels = panels_of(scenario, results.groups);
  if (panels.empty()) return std::nullopt;
  Plot plot{"running_mean",
            "Mean goal difference (a minus b) by number of pairs of legs, with Student's 95 % "
            "interval for these pairs. Not for stopping early: if many intervals are checked in "
            "turn, some miss the true value far more often than one in twenty.",
            csv_of(panels), ""};
  plot.about += note_of_cut(panels.size());
  panels.resize(std::min(panels.size(), kMostGroupsInPlot));
  plot.script = script_of(panels);
  return plot;
}

}  // namespace autoref::experiments
