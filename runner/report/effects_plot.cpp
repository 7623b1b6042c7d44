#include "runner/io/csv.hpp"
#include "runner/report/plots.hpp"

namespace autoref::runner {

std::optional<Plot> effects_plot(const ExperimentResults& results) {
  if (results.effects.empty()) return std::nullopt;
  Plot plot{"effects", "", "row,effect,pairs,mean_diff,low95,high95\n", ""};
  std::vector<std::string> names;
  for (const Effect& effect : results.effects) {
    names.push_back(effect_name(effect));
    const auto& [low, high] = bounds_of(effect.interval);
    plot.csv += csv_line({std::to_string(names.size()), names.back(), std::to_string(effect.pairs),
                          number_cell(effect.mean), number_cell(low), number_cell(high)}) +
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

}  // namespace autoref::runner
