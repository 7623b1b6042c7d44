// Columns of a table, each with a name and a function that gives its value in a row. The same list
// defines the header and rows of a CSV file or text table, and the members of JSON objects.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/csv.hpp"
#include "io/json.hpp"

namespace autoref::io {

// A text, a whole number, or a number that may be missing.
using ColumnValue = std::variant<std::string, int, std::optional<double>>;

// `Row` is the type of object that a row describes.
template <typename Row>
struct TableColumn {
  std::string name;
  std::function<ColumnValue(const Row&)> value;
  bool is_in_json = false;
};
inline constexpr bool kInJson = true;

template <typename Row>
using TableColumns = std::vector<TableColumn<Row>>;

// The columns of all lists, one after the other.
template <typename Row, typename... Others>
TableColumns<Row> joined(TableColumns<Row> columns, const Others&... others) {
  (columns.insert(columns.end(), others.begin(), others.end()), ...);
  return columns;
}

// A number as a CSV cell, with four decimals; "inf" and "-inf" for infinity, empty if nullopt.
std::string number_cell(std::optional<double> number);

// The value as a cell; optional numbers are formatted by number_cell().
std::string cell_of(const ColumnValue& value);

// Adds the value to a JSON object, unrounded; a missing number is null.
void add_member(Json& object, const std::string& name, const ColumnValue& value);

// The columns' names: the header of a table.
template <typename Row>
Cells heads_of(const TableColumns<Row>& columns) {
  Cells names;
  for (const TableColumn<Row>& column : columns) names.push_back(column.name);
  return names;
}

// The columns' cells in a row.
template <typename Row>
Cells cells_of(const TableColumns<Row>& columns, const Row& row) {
  Cells texts;
  for (const TableColumn<Row>& column : columns) texts.push_back(cell_of(column.value(row)));
  return texts;
}

// Appends the columns to a table: their names to its header, the first of `rows`, and the cells for
// each of `items` to one of the rows below. Throws std::out_of_range if there are fewer rows.
template <typename Row>
void append_columns(std::vector<Cells>& rows, const TableColumns<Row>& columns,
                    const std::vector<Row>& items) {
  append(rows.at(0), heads_of(columns));
  for (std::size_t i = 0; i < items.size(); ++i)
    append(rows.at(i + 1), cells_of(columns, items[i]));
}

// The table of these columns: its header, then a row for each of `items`.
template <typename Row>
std::vector<Cells> table_rows(const TableColumns<Row>& columns, const std::vector<Row>& items) {
  std::vector<Cells> rows(items.size() + 1);
  append_columns(rows, columns, items);
  return rows;
}

// Adds to a JSON object the row's values in the columns that are included in JSON.
template <typename Row>
void add_members(Json& object, const TableColumns<Row>& columns, const Row& row) {
  for (const TableColumn<Row>& column : columns)
    if (column.is_in_json) add_member(object, column.name, column.value(row));
}

// The position of the column with this name. Throws std::logic_error if the table has no such
// column.
std::size_t column_named(const Cells& heads, std::string_view name);

// The positions of several columns, in the order of `names`. Throws like column_named().
std::vector<std::size_t> columns_named(const Cells& heads, const Cells& names);

// Formats one line per row as CSV.
std::string csv_text(const std::vector<Cells>& rows);

}  // namespace autoref::io
