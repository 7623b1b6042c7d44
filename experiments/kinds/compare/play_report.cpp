#include "experiments/kinds/compare/play_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "experiments/analysis/groups.hpp"
#include "experiments/kinds/compare/parts_report.hpp"
#include "io/csv.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {
namespace {

constexpr std::size_t kMostDifferencesShown = 8;  // in the table

io::TableColumns<PlayDifference> play_columns() {
  const auto number = [](double PlayDifference::*member) {
    return [member](const PlayDifference& one) { return std::optional(one.*member); };
  };
  return io::joined(
      io::TableColumns<PlayDifference>{{"count", &PlayDifference::name, io::kInJson},
                                       {"of_new", number(&PlayDifference::of_new), io::kInJson},
                                       {"of_old", number(&PlayDifference::of_old), io::kInJson},
                                       {"diff", number(&PlayDifference::mean), io::kInJson}},
      interval_columns<PlayDifference>("diff_", &PlayDifference::interval, io::kInJson),
      io::TableColumns<PlayDifference>{
          {"p", [](const PlayDifference& one) { return p_cell(one.p); }},
          {"p_holm", [](const PlayDifference& one) { return p_cell(one.p_holm); }}});
}

}  // namespace

std::string most_certain_text(const std::vector<PlayDifference>& differences) {
  const std::vector<PlayDifference> certain = certain_differences(differences);
  if (certain.empty()) return "No difference in play is certain.";
  const PlayDifference& first = certain.front();
  return fmt::format("Most certain difference in play: {}, {:.2f} per game instead of {:.2f}.",
                     first.name, first.of_new, first.of_old);
}

io::TextBlocks play_table(const std::vector<PlayDifference>& differences) {
  std::vector<PlayDifference> shown = certain_differences(differences);
  if (shown.empty()) return {};
  shown.resize(std::min(shown.size(), kMostDifferencesShown));
  std::vector<io::Cells> rows = {{"per game", "new", "old", "new minus old [95 %]"}};
  for (const PlayDifference& one : shown) {
    rows.push_back({one.name, fmt::format("{:.2f}", one.of_new), fmt::format("{:.2f}", one.of_old),
                    mean_with_interval(one.mean, one.interval)});
  }
  return {"What new does differently, the most certain difference first:\n\n",
          io::TextTable{std::move(rows), {io::Align::kLeft}, 1},
          "\nOnly differences with a p of at most 0.05, corrected for their number. They may be "
          "causes of the goal difference or consequences: who concedes more has more kick-offs.\n"};
}

std::string play_csv(const std::vector<PlayDifference>& differences) {
  return io::csv_text(io::table_rows(play_columns(), differences));
}

io::Json play_json(const std::vector<PlayDifference>& differences) {
  io::Json list = io::Json::array();
  for (const PlayDifference& one : differences) {
    list.push_back(io::Json::object());
    io::add_members(list.back(), play_columns(), one);
    list.back()["p_holm"] = one.p_holm;
  }
  return list;
}

}  // namespace autoref::experiments
