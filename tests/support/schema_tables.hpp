// Reads the names of columns and keys from the tables of docs/schemas.md and other pages.
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref {

struct SchemaSection {
  std::string title;
  std::vector<std::vector<std::string>> rows;  // cells of the table's rows, without its header

  // Names in the order of the table. A row's first cell may contain several names, each in
  // backticks.
  std::vector<std::string> names() const;
};

// Splits "| a | b |" into its cells.
inline std::vector<std::string> cells_of_table_row(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line.substr(1));
  for (std::string cell; std::getline(text, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' ');
    const std::size_t last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

inline std::vector<std::string> SchemaSection::names() const {
  std::vector<std::string> names;
  for (const std::vector<std::string>& row : rows) {
    std::istringstream text(row.front());
    std::string between;
    std::string name;
    while (std::getline(text, between, '`') && std::getline(text, name, '`')) names.push_back(name);
  }
  return names;
}

// Every "## " section of a page with the rows below it.
inline std::vector<SchemaSection> sections_of(const std::string& page) {
  std::vector<SchemaSection> sections;
  std::istringstream text(content_of(in_checkout(page)));
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("## ")) sections.push_back({line.substr(3), {}});
    const bool is_head = line.starts_with("| name |") || line.starts_with("|---");
    if (!sections.empty() && line.starts_with("|") && !is_head) {
      sections.back().rows.push_back(cells_of_table_row(line));
    }
  }
  return sections;
}

inline std::vector<SchemaSection> schema_sections() { return sections_of("docs/schemas.md"); }

}  // namespace autoref
