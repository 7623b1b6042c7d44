#include "experiments/report/run_results.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/analysis/standings.hpp"
#include "experiments/report/document.hpp"
#include "experiments/report/sections.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kRankEnd = ".\u00a0";  // with a no-break space

void append_blocks(Section& section, Section blocks) {
  for (Block& block : blocks) section.push_back(std::move(block));
}

void append_table(Section& section, Table table) {
  const std::size_t rows = table.rows.size() - 1;
  if (rows > kMostTableRows) table.rows.resize(kMostTableRows + 1);
  section.emplace_back(std::move(table));
  if (rows > kMostTableRows)
    section.emplace_back(Paragraph{fmt::format("and {} more", rows - kMostTableRows)});
}

// The number of columns up to the last left-aligned one.
std::size_t names_in(const io::TextTable& table) {
  const auto last = std::find(table.columns.rbegin(), table.columns.rend(), io::Align::kLeft);
  return std::max(table.keys, static_cast<std::size_t>(table.columns.rend() - last));
}

// The rank is put next to the name because a phone keeps only the first column in view.
Table ranked(const std::vector<Standing>& standings) {
  Table table{standings_rows(standings), 1};
  for (std::vector<std::string>& row : table.rows) {
    if (!row[0].empty()) row[1] = row[0] + kRankEnd + row[1];
    row.erase(row.begin());
  }
  return table;
}

Section tournament_sections(const ExperimentResults& results) {
  Section section = {Heading{"Standings"}};
  append_table(section, ranked(results.standings));
  if (results.standings.size() <= kMostCrossed) append_blocks(section, crosstable_section(results));
  section.emplace_back(Heading{"Matchups"});
  const io::TextTable matchups = matchups_table(results.groups);
  append_table(section, {matchups.rows, names_in(matchups)});
  return section;
}

}  // namespace

Section blocks_of(const io::TextBlocks& blocks) {
  Section section;
  for (const auto& block : blocks) {
    if (const auto* const table = std::get_if<io::TextTable>(&block)) {
      append_table(section, {table->rows, names_in(*table)});
      continue;
    }
    std::string text = std::get<std::string>(block);
    text.erase(0, text.find_first_not_of('\n'));
    text.erase(text.find_last_not_of('\n') + 1);
    if (text.empty()) continue;
    const bool is_line = text.find('\n') == std::string::npos;
    is_line ? section.emplace_back(Paragraph{text}) : section.emplace_back(Verbatim{text});
  }
  return section;
}

std::string run_results_html(const ExperimentResults& results) {
  Section section;
  if (!results.standings.empty()) {
    section = tournament_sections(results);
  } else {
    section = bracket_section(results);
    section.emplace_back(Heading{results.ties.empty() ? "Results" : "Ties"});
    append_blocks(section, blocks_of(results.table));
  }
  append_blocks(section, meaning_of(results));
  return html_fragment(section);
}

}  // namespace autoref::experiments
