#include "experiments/report/plots.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {

std::optional<Plot> effects_plot(const ExperimentResults& results) {
  if (results.effects.empty()) return std::nullopt;
  Plot plot{"effects", "", "row,effect,pairs,mean_diff,low95,high95\n", ""};
  std::vector<std::string> names;
  for (const Effect& effect : results.effects) {
    names.push_back(effect_name(effect));
    const auto& [low, high] = bounds_of(effect.interval);
    plot.csv +=
        io::csv_line({std::to_string(names.size()), names.back(), std::to_string(effect.pairs),
                      io::number_cell(effect.mean), io::number_cell(low), io::number_cell(high)}) +
        "\n";
  }
  plot.about =
      "How far each value of a factor changes the mean goal difference from that with the factor's "
      "first value, averaged over the other factors, and how far one value changes the effect of "
      "another; bars: Student's 95 % intervals over pairs of legs.";
  plot.about += note_of_cut(names.size());
  names.resize(std::min(names.size(), kMostGroupsInPlot));
  plot.script = interval_rows_script("effects", names, "effect",
                                     "change of a minus b in goals per game, 95 % interval");
  return plot;
}

}  // namespace autoref::experiments
