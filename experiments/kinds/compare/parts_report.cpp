#include "experiments/kinds/compare/parts_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "io/csv.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {
namespace {

// A part with a smaller absolute value in every column would read as zero.
constexpr double kShown = 0.005;

bool is_shown(const DifferencePart& part) {
  const double largest =
      std::max({std::abs(part.of_new), std::abs(part.of_old), std::abs(part.each_other),
                std::abs(part.attack), std::abs(part.defence), std::abs(part.mean)});
  return largest >= kShown;
}

// All rows, in the order of the table and of parts.csv.
std::vector<const DifferencePart*> all_parts(const DifferenceParts& parts) {
  std::vector<const DifferencePart*> all;
  const auto add = [&all](const std::vector<DifferencePart>& some) {
    for (const DifferencePart& part : some) all.push_back(&part);
  };
  add(parts.by_start);
  all.push_back(&parts.chances);
  add(parts.by_passes);
  add(parts.others);
  all.push_back(&parts.goals);
  return all;
}

bool is_sum(const DifferenceParts& parts, const DifferencePart* part) {
  return part == &parts.chances || part == &parts.goals;
}

io::Cells cells_of(const DifferenceParts& parts, const DifferencePart& part, bool has_opponents) {
  const bool is_certain = !is_sum(parts, &part) && part.p_holm <= kSignificant;
  const std::string difference =
      mean_with_interval(part.mean, part.interval) + (is_certain ? " *" : "  ");
  const auto number = [](double value) { return fmt::format("{:+.2f}", value); };
  if (has_opponents)
    return {part.name, number(part.each_other), number(part.attack), number(part.defence),
            difference};
  return {part.name, fmt::format("{:.2f}", part.of_new), fmt::format("{:.2f}", part.of_old),
          difference};
}

io::TableColumns<DifferencePart> part_columns() {
  const auto number = [](double DifferencePart::*member) {
    return [member](const DifferencePart& part) { return std::optional(part.*member); };
  };
  return io::joined(
      io::TableColumns<DifferencePart>{
          {"part", &DifferencePart::name, io::kInJson},
          {"of_new", number(&DifferencePart::of_new), io::kInJson},
          {"of_old", number(&DifferencePart::of_old), io::kInJson},
          {"each_other", number(&DifferencePart::each_other), io::kInJson},
          {"attack", number(&DifferencePart::attack), io::kInJson},
          {"defence", number(&DifferencePart::defence), io::kInJson},
          {"diff", number(&DifferencePart::mean), io::kInJson}},
      interval_columns<DifferencePart>("diff_", &DifferencePart::interval, io::kInJson),
      io::TableColumns<DifferencePart>{
          {"p", [](const DifferencePart& part) { return p_cell(part.p); }},
          {"p_holm", [](const DifferencePart& part) { return p_cell(part.p_holm); }}});
}

}  // namespace

std::string mean_with_interval(double mean, const std::optional<Interval>& interval) {
  const auto number = [](double value) {
    const bool reads_as_zero = value != 0 && std::abs(value) < 0.005;
    return reads_as_zero ? fmt::format("{:+.3f}", value) : fmt::format("{:+.2f}", value);
  };
  if (!interval) return number(mean);
  return fmt::format("{} [{}, {}]", number(mean), number(interval->low), number(interval->high));
}

std::string goals_with_interval(double mean, const std::optional<Interval>& interval) {
  std::string text = mean_with_interval(mean, interval);
  return text.insert(std::min(text.find(' '), text.size()), " goals per game");
}

std::string most_certain_text(const DifferenceParts& parts) {
  const DifferencePart* part = parts.strongest_candidate();
  const char* const uncertain = "No single part of the difference is certain.";
  if (part == nullptr || part->p > kSignificant) return uncertain;
  const std::string named =
      fmt::format("{}, {}", part->name, goals_with_interval(part->mean, part->interval));
  if (part == parts.most_certain())
    return fmt::format("Most certain part of the difference: {}.", named);
  return fmt::format(
      "{} The strongest candidate: {}; p = {:.2g}, corrected for the number of parts.", uncertain,
      named, part->p_holm);
}

io::TextBlocks parts_table(const DifferenceParts& parts, bool has_opponents) {
  std::vector<io::Cells> rows = {
      has_opponents
          ? io::Cells{"goals per game", "each other", "attack", "defence", "new minus old [95 %]  "}
          : io::Cells{"goals per game", "new", "old", "new minus old [95 %]  "}};
  for (const DifferencePart* part : all_parts(parts)) {
    if (is_sum(parts, part) || is_shown(*part))
      rows.push_back(cells_of(parts, *part, has_opponents));
  }
  std::string explanation =
      "Chances are expected goals (xG), by how the team gained the ball and by whether it passed. "
      "In the last column, chances, finishing, saves and own goals add up to goals. *: p is at "
      "most 0.05, corrected for the number of parts.";
  if (has_opponents)
    explanation +=
        " The three columns in the middle add up to the difference: games of the two teams against "
        "each other, and what changed at the opponents' goals and at their own.";
  return {"Where the difference comes from:\n\n",
          io::TextTable{std::move(rows), {io::Align::kLeft}, 1}, "\n" + explanation + "\n"};
}

std::string parts_csv(const DifferenceParts& parts) {
  std::vector<DifferencePart> rows;
  for (const DifferencePart* part : all_parts(parts)) rows.push_back(*part);
  return io::csv_text(io::table_rows(part_columns(), rows));
}

io::Json parts_json(const DifferenceParts& parts) {
  io::Json list = io::Json::array();
  for (const DifferencePart* part : all_parts(parts)) {
    list.push_back(io::Json::object());
    io::add_members(list.back(), part_columns(), *part);
    list.back()["p_holm"] = part->p_holm;
  }
  return list;
}

}  // namespace autoref::experiments
