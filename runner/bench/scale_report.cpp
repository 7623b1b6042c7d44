// What `autoref bench --scale` prints.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "runner/bench/scale_bench.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/json.hpp"

namespace autoref::runner {
namespace {

std::string_view growth_name(Growth growth) {
  switch (growth) {
    case Growth::kLinearOrBetter:
      return "linear_or_better";
    case Growth::kUndecided:
      return "undecided";
    case Growth::kSuperlinear:
      return "superlinear";
    case Growth::kNotApplicable:
      break;
  }
  return "";
}

std::string growth_sentence(const ScaleTable& table) {
  const std::string& base = table.rows[table.base].name;
  switch (growth_of(table)) {
    case Growth::kLinearOrBetter:
      return fmt::format("Linear or better: no row beyond {} costs more per {}.\n\n", base,
                         table.unit);
    case Growth::kUndecided:
      return fmt::format(
          "Not distinguishable from linear: a row beyond {} costs more per {}, but the interval "
          "contains 1.\n\n",
          base, table.unit);
    case Growth::kSuperlinear:
      return fmt::format("Worse than linear: a row beyond {} costs more per {}.\n\n", base,
                         table.unit);
    case Growth::kNotApplicable:
      break;
  }
  return "";
}

std::string with_interval(double ratio, const Interval& interval, double factor) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]", factor * ratio, factor * interval.low,
                     factor * interval.high);
}

std::string markdown_row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string markdown_of(const ScaleTable& table) {
  const bool has_units = !table.unit.empty();
  std::vector<std::string> head = {table.name, "cost of a frame"};
  if (has_units) head.push_back("cost per " + table.unit);
  std::string text = markdown_row(head);
  text += has_units ? "|---|--:|--:|\n" : "|---|--:|\n";
  for (const ScaleRow& row : table.rows) {
    std::vector<std::string> cells = {row.name, with_interval(row.ratio, row.interval, 1)};
    if (has_units) cells.push_back(with_interval(row.ratio, row.interval, table.per_unit(row)));
    text += markdown_row(cells);
  }
  text +=
      fmt::format("\n1 is the row {}: {:.0f} ns of processor time per frame on this machine.\n\n",
                  table.rows[table.base].name, table.base_ns_per_frame);
  return text + growth_sentence(table);
}

Json json_of_row(const ScaleTable& table, const ScaleRow& row) {
  Json json = {{"name", row.name},
               {"ratio", rounded(row.ratio, 4)},
               {"ratio_low95", rounded(row.interval.low, 4)},
               {"ratio_high95", rounded(row.interval.high, 4)}};
  json["ratio_per_unit"] =
      table.unit.empty() ? Json() : Json(rounded(table.per_unit(row) * row.ratio, 4));
  return json;
}

}  // namespace

std::string scale_markdown(const std::vector<ScaleTable>& tables, const ScaleOptions& options) {
  std::string text = fmt::format(
      "# The cost of a frame\n\nProcessor time per frame of games of `{0}` against `{0}`, two "
      "halves "
      "of {1:g} s, relative to one row of each table in the same round: median of {2} rounds with "
      "its "
      "95 % confidence interval (sign test).\n\n",
      team_of(options.teams), options.half_s, options.rounds);
  for (const ScaleTable& table : tables) text += markdown_of(table);
  text.pop_back();
  return text;
}

std::string scale_json(const std::vector<ScaleTable>& tables) {
  Json series = Json::array();
  for (const ScaleTable& table : tables) {
    Json rows = Json::array();
    for (const ScaleRow& row : table.rows) rows.push_back(json_of_row(table, row));
    const std::string_view growth = growth_name(growth_of(table));
    series.push_back({{"name", table.name},
                      {"unit", table.unit.empty() ? Json() : Json(table.unit)},
                      {"base", table.rows[table.base].name},
                      {"base_ns_per_frame", rounded(table.base_ns_per_frame, 1)},
                      {"growth", growth.empty() ? Json() : Json(growth)},
                      {"rows", std::move(rows)}});
  }
  return json_text({{"series", std::move(series)}});
}

int run_scale_bench(const ScaleOptions& options, bool json) {
  const std::vector<ScaleTable> tables = bench_scale(options);
  if (json) {
    fmt::print("{}\n", scale_json(tables));
  } else {
    fmt::print("{}", scale_markdown(tables, options));
  }
  return kDone;
}

}  // namespace autoref::runner
