#include <fmt/format.h>

#include <algorithm>

#include "runner/csv.hpp"
#include "runner/report/group_names.hpp"
#include "runner/report/plots.hpp"
#include "runner/report/running_mean.hpp"

namespace autoref::runner {
namespace {

constexpr std::size_t kLongestTitle = 28;  // letters
constexpr int kFrameHeight_px = 10;

struct Panel {
  std::string name;
  std::vector<RunningMean> means;
};

// Panels beside each other, and how tall one is.
struct Layout {
  int columns = 1;
  int height_px = 330;
};

Layout layout_for(std::size_t panels) {
  if (panels <= 1) return {1, 330};
  if (panels <= 4) return {2, 250};
  return panels <= 15 ? Layout{3, 200} : Layout{4, 170};
}

std::vector<Panel> panels_of(const Scenario& scenario, const std::vector<Group>& groups) {
  const std::vector<std::string> names = names_of(scenario, groups);
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Panel panel{names[i], running_means(groups[i])};
    if (!panel.means.empty()) panels.push_back(std::move(panel));
  }
  return panels;
}

std::string csv_of(const std::vector<Panel>& panels) {
  std::string csv = "panel,name,pairs,mean_diff,low95,high95\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    for (std::size_t n = 0; n < panels[i].means.size(); ++n) {
      const auto& [low, high] = bounds_of(panels[i].means[n].interval);
      csv += csv_line({std::to_string(i + 1), panels[i].name, std::to_string(n + 1),
                       number_cell(panels[i].means[n].mean), number_cell(low), number_cell(high)}) +
             "\n";
    }
  }
  return csv;
}

// An array of the script: `value` of each panel.
template <typename Value>
std::string array_of(const char* name, const std::vector<Panel>& panels, const Value& value) {
  std::vector<std::string> values;
  for (const Panel& panel : panels) values.push_back(value(panel));
  return fmt::format("array {}[{}] = [{}]\n", name, values.size(), fmt::join(values, ", "));
}

std::string arrays_of(const std::vector<Panel>& panels) {
  return array_of(
             "name", panels,
             [](const Panel& panel) { return script_text(shortened(panel.name, kLongestTitle)); }) +
         array_of("pairs", panels,
                  [](const Panel& panel) {
                    return std::to_string(std::max<std::size_t>(panel.means.size(), 2));
                  }) +
         array_of("low", panels,
                  [](const Panel& panel) { return number_cell(span_to_show(panel.means).low); }) +
         array_of("high", panels,
                  [](const Panel& panel) { return number_cell(span_to_show(panel.means).high); });
}

std::string script_of(const std::vector<Panel>& panels) {
  const Layout layout = layout_for(panels.size());
  const int rows = (static_cast<int>(panels.size()) + layout.columns - 1) / layout.columns;
  return script_head("running_mean", kFrameHeight_px + rows * layout.height_px) +
         arrays_of(panels) +
         fmt::format(
             "set xlabel 'pairs of legs' font ',11' offset 0,0.5\n"
             "set title font ',13' offset 0,-0.6\n"
             "set tics font ',11'\n"
             "of(i, column_name) = column('panel') == i ? column(column_name) : NaN\n"
             "set multiplot layout {0},{1}\n"
             "do for [i=1:{2}] {{\n"
             "  set title name[i]\n"
             "  set xrange [1:pairs[i]]\n"
             "  set yrange [low[i]:high[i]]\n"
             "  plot data using (of(i, 'pairs')):(of(i, 'low95')):(of(i, 'high95')) with "
             "filledcurves lc rgb '{3}' fs transparent solid 0.18 notitle, \\\n"
             "       0 with lines lc rgb '#777777' dt 2 notitle, \\\n"
             "       data using (of(i, 'pairs')):(of(i, 'mean_diff')) with lines lw 2 lc rgb '{3}' "
             "notitle\n"
             "}}\n"
             "unset multiplot\n",
             rows, layout.columns, panels.size(), kBlue);
}

}  // namespace

std::optional<Plot> running_mean_plot(const Scenario& scenario, const ExperimentResults& results) {
  std::vector<Panel> panels = panels_of(scenario, results.groups);
  if (panels.empty()) return std::nullopt;
  Plot plot{"running_mean",
            "Mean goal difference (a minus b) after so many pairs of legs, with Student's 95 % "
            "interval of these pairs. Not for stopping: of many intervals looked at in turn, some "
            "leave the truth out far more often than one in twenty.",
            csv_of(panels), ""};
  panels.resize(std::min(panels.size(), kMostGroupsInPlot));
  plot.script = script_of(panels);
  return plot;
}

}  // namespace autoref::runner
