#include "app/log/comparison_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "experiments/report/document.hpp"
#include "experiments/report/plot.hpp"
#include "io/csv.hpp"
#include "io/table_columns.hpp"
#include "logs/compare/measures.hpp"

namespace autoref::app {
namespace {

using experiments::Plot;

constexpr int kSharesHeight_px = 300;
constexpr double kShownShare = 0.995;  // of the values; the largest ones would squeeze the rest

Plot distances_plot(const logs::GameComparison& comparison) {
  std::vector<std::string> labels;
  std::string csv = "row,measure,mean_diff,low95,high95\n";
  const auto add = [&](const std::string& name, const logs::Distance& distance) {
    labels.push_back(name);
    csv += io::csv_line({std::to_string(labels.size()), name, io::number_cell(distance.value),
                         io::number_cell(distance.low), io::number_cell(distance.high)}) +
           "\n";
  };
  for (const logs::MeasureComparison& compared : comparison.measures) {
    if (compared.distance)
      add(std::string(logs::entry_of(compared.measure).name), *compared.distance);
  }
  if (comparison.mean) add("mean", *comparison.mean);
  return {"distances", "Distance of each measure with its 95 % interval.", csv,
          experiments::interval_rows_script("distances", labels, "",
                                            "distance from the recorded games")};
}

std::string shares_csv(const logs::MeasureEntry& entry, const logs::MeasureCounts& recorded,
                       const logs::MeasureCounts& simulated) {
  std::string csv = "below,recorded,simulated\n0,0,0\n";
  const std::size_t bins = recorded.bins().size();
  double recorded_below = 0;
  double simulated_below = 0;
  for (std::size_t i = 0; i < bins; ++i) {
    recorded_below += static_cast<double>(recorded.bins()[i]);
    simulated_below += static_cast<double>(simulated.bins()[i]);
    csv +=
        io::csv_line({io::number_cell(entry.highest * static_cast<double>(i + 1) /
                                      static_cast<double>(bins)),
                      io::number_cell(recorded_below / static_cast<double>(recorded.values())),
                      io::number_cell(simulated_below / static_cast<double>(simulated.values()))}) +
        "\n";
  }
  return csv;
}

Plot shares_plot(const logs::MeasureEntry& entry, const logs::MeasureCounts& recorded,
                 const logs::MeasureCounts& simulated) {
  const std::string name(entry.name);
  const double highest = std::max(logs::quantile_of(entry, recorded, kShownShare),
                                  logs::quantile_of(entry, simulated, kShownShare));
  return {name, std::string(entry.about), shares_csv(entry, recorded, simulated),
          experiments::script_head(name, kSharesHeight_px) +
              fmt::format("set xlabel {0}\n"
                          "set ylabel 'share of values below'\n"
                          "set xrange [0:{1:.6g}]\n"
                          "set yrange [0:1]\n"
                          "set key bottom right\n"
                          "plot data using 'below':'recorded' with lines lw 2 lc rgb '{2}' title "
                          "'recorded', \\\n"
                          "     data using 'below':'simulated' with lines lw 2 lc rgb '{3}' title "
                          "'simulated'\n",
                          experiments::script_text(fmt::format("{} in {}", entry.name, entry.unit)),
                          highest, experiments::kBlue, experiments::kVermilion)};
}

std::vector<Plot> plots_of(const logs::GameComparison& comparison, const logs::AllCounts& recorded,
                           const logs::AllCounts& simulated) {
  std::vector<Plot> plots;
  if (comparison.mean) plots.push_back(distances_plot(comparison));
  for (std::size_t i = 0; i < logs::kMeasureCount; ++i) {
    const logs::MeasureEntry& entry = logs::kMeasures[i];
    if (entry.kind == logs::MeasureKind::kDistribution && recorded[i].values() > 0 &&
        simulated[i].values() > 0)
      plots.push_back(shares_plot(entry, recorded[i], simulated[i]));
  }
  return plots;
}

// Draws the plots until one fails.
void add_drawings(const std::vector<Plot>& plots, experiments::Document& document,
                  std::string& trouble) {
  for (const Plot& plot : plots) {
    const experiments::Drawing drawing = experiments::draw(plot);
    if (drawing.svg.empty()) {
      trouble =
          drawing.is_missing
              ? "the page has no plots, because gnuplot is not installed: run apt-get "
                "install gnuplot-nox"
              : fmt::format("the page lacks plots from {} on: {}", plot.name, drawing.trouble);
      return;
    }
    document.blocks.emplace_back(
        experiments::ResultDrawing{plot.name + ".svg", plot.about, drawing.svg});
  }
}

experiments::List measures_list() {
  experiments::List list;
  for (const logs::MeasureEntry& entry : logs::kMeasures)
    list.items.push_back(fmt::format("{}: {}", entry.name, entry.about));
  return list;
}

}  // namespace

ComparisonPage comparison_page(const logs::GameComparison& comparison,
                               const logs::ComparedTimes& times, const logs::AllCounts& recorded,
                               const logs::AllCounts& simulated) {
  experiments::Document document{"Simulated games compared with recorded ones", {}};
  document.blocks = {
      experiments::Strong{logs::mean_text(comparison)},
      experiments::Paragraph{logs::compared_text(times)},
      experiments::Table{logs::comparison_rows(comparison), 2},
      experiments::Paragraph{
          "Recorded and simulated: median of a distribution, share, or rate per minute of running "
          "play, and in brackets the number of values. Distance: the largest difference between "
          "the shares of values below a bound; of two shares, their difference; of two rates, "
          "their difference divided by their sum. What chance contributes is subtracted; where "
          "the interval begins at 0, chance may explain all of it."}};
  ComparisonPage page;
  document.blocks.emplace_back(experiments::Heading{"Distances and distributions"});
  add_drawings(plots_of(comparison, recorded, simulated), document, page.trouble);
  document.blocks.emplace_back(experiments::Heading{"Measures"});
  document.blocks.emplace_back(measures_list());
  page.html = experiments::html_of(document);
  return page;
}

}  // namespace autoref::app
