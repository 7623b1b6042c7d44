// results/README.md quotes what the fits of tools/fitting wrote to results/reference.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/csv.hpp"
#include "tests/checkout.hpp"
#include "tests/support/has_part.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::tools {
namespace {

using CsvRow = std::map<std::string, std::string>;

std::vector<CsvRow> rows_of_reference(const std::string& file) {
  const std::string csv = content_of(in_checkout("results/reference/" + file));
  const std::vector<std::string_view> lines = io::complete_lines(csv);
  const io::Cells names = io::csv_cells(lines.at(0)).value();
  std::vector<CsvRow> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const io::Cells cells = io::csv_cells(lines[i]).value();
    CsvRow& row = rows.emplace_back();
    for (std::size_t column = 0; column < names.size(); ++column)
      row[names[column]] = cells.at(column);
  }
  return rows;
}

// The rows of each rule book, by model.
using RowsByModel = std::map<std::string, CsvRow>;
std::map<std::string, RowsByModel> rows_by_rules(const std::string& file) {
  std::map<std::string, RowsByModel> rows;
  for (CsvRow& row : rows_of_reference(file)) {
    const std::string rules = row["rules"];
    const std::string model = row["model"];
    rows[rules][model] = std::move(row);
  }
  return rows;
}

std::string rounded(const std::string& number, int decimals) {
  return fmt::format("{:.{}f}", std::stod(number), decimals);
}

void expect_quoted(const io::Cells& cells) {
  static const std::string kPage = content_of(in_checkout("results/README.md"));
  const std::string row = fmt::format("| {} |\n", fmt::join(cells, " | "));
  EXPECT_TRUE(has(kPage, row)) << row;
}

TEST(QuotedResults, OfChancesAreThoseOfTheFit) {
  const std::vector<CsvRow> rows = rows_of_reference("chances/chances.csv");
  ASSERT_EQ(rows.size(), 10U);
  for (const CsvRow& row : rows) {
    expect_quoted({row.at("rules"), row.at("model") == "xg" ? "xG" : "xGOT", row.at("tested_shots"),
                   row.at("goals"), rounded(row.at("expected_goals"), 0),
                   rounded(row.at("brier"), 3), rounded(row.at("brier_of_rate"), 3)});
  }
}

// The rows of the teams left out, with expected goals in percent of the goals, in their order.
std::vector<std::pair<int, CsvRow>> shares_of_goals(const std::string& model) {
  std::vector<std::pair<int, CsvRow>> shares;
  for (const CsvRow& row : rows_of_reference("chances/teams.csv")) {
    if (row.at("model") != model) continue;
    shares.emplace_back(static_cast<int>(std::lround(100 * std::stod(row.at("expected_goals")) /
                                                     std::stod(row.at("goals")))),
                        row);
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

TEST(QuotedResults, OfTeamsLeftOutAreThoseOfTheFit) {
  std::string page = content_of(in_checkout("results/README.md"));
  std::replace(page.begin(), page.end(), '\n', ' ');
  const auto xg = shares_of_goals("xg");
  const auto xgot = shares_of_goals("xgot");
  ASSERT_EQ(xg.size(), 35U);
  ASSERT_EQ(xgot.size(), 35U);
  const auto expect_text = [&](const std::string& text) { EXPECT_TRUE(has(page, text)) << text; };
  expect_text(
      fmt::format("For 33 of 35 teams and rule books, xG is between {} and {} % of the goals.",
                  xg[1].first, xg[33].first));
  expect_text(fmt::format("{} % for `{}` and {} % for `{}`, both under the rules of {}",
                          xg[0].first, xg[0].second.at("left_out"), xg[34].first,
                          xg[34].second.at("left_out"), xg[0].second.at("rules")));
  EXPECT_EQ(xg[0].second.at("rules"), xg[34].second.at("rules"));
  expect_text(fmt::format("between {} and {} % in 32 of 35", xgot[1].first, xgot[32].first));
}

TEST(QuotedResults, OfSituationsAreThoseOfTheFit) {
  const auto books = rows_by_rules("win-probability/win-probability.csv");
  ASSERT_EQ(books.size(), 5U);
  for (const auto& [rules, models] : books) {
    io::Cells cells = {rules, models.at("scores").at("tested_cases")};
    for (const char* model : {"scores", "concedes"}) {
      const CsvRow& row = models.at(model);
      io::append(cells, {row.at("happened"), rounded(row.at("expected_happened"), 0),
                         rounded(row.at("brier"), 3), rounded(row.at("brier_of_rate"), 3)});
    }
    expect_quoted(cells);
  }
}

// "54, 54, 54": a column's numbers after each quarter of the game.
std::string after_quarters(const RowsByModel& models, const std::string& outcome,
                           const std::string& column, int decimals) {
  io::Cells numbers;
  for (const int quarter : {1, 2, 3}) {
    const CsvRow& row = models.at(fmt::format("{}_after_{}", outcome, quarter));
    numbers.push_back(rounded(row.at(column), decimals));
  }
  return fmt::format("{}", fmt::join(numbers, ", "));
}

TEST(QuotedResults, OfWinProbabilitiesAreThoseOfTheFit) {
  const auto books = rows_by_rules("win-probability/win-probability.csv");
  ASSERT_EQ(books.size(), 5U);
  for (const auto& [rules, models] : books) {
    io::Cells cells = {rules, after_quarters(models, "win", "tested_cases", 0)};
    for (const char* outcome : {"win", "draw"}) {
      io::append(cells,
                 {after_quarters(models, outcome, "happened", 0),
                  after_quarters(models, outcome, "expected_happened", 0),
                  after_quarters(models, outcome, "brier", 3),
                  rounded(models.at(fmt::format("{}_after_1", outcome)).at("brier_of_rate"), 2)});
    }
    expect_quoted(cells);
  }
}

}  // namespace
}  // namespace autoref::tools
