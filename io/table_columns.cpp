#include "io/table_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace autoref::io {
namespace {

struct AsCell {
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(int number) const { return std::to_string(number); }
  std::string operator()(std::optional<double> number) const { return number_cell(number); }
};

struct AsJson {
  Json operator()(std::optional<double> number) const { return json_number(number); }
  Json operator()(const auto& value) const { return value; }
};

}  // namespace

std::string number_cell(std::optional<double> number) {
  return number ? fmt::format("{:.4f}", *number) : "";
}

std::string cell_of(const ColumnValue& value) { return std::visit(AsCell{}, value); }

void add_member(Json& object, const std::string& name, const ColumnValue& value) {
  object[name] = std::visit(AsJson{}, value);
}

std::size_t column_named(const Cells& heads, std::string_view name) {
  const auto found = std::find(heads.begin(), heads.end(), name);
  if (found == heads.end())
    throw std::logic_error(fmt::format("a table does not have the column '{}'", name));
  return static_cast<std::size_t>(found - heads.begin());
}

std::vector<std::size_t> columns_named(const Cells& heads, const Cells& names) {
  std::vector<std::size_t> positions;
  for (const std::string& name : names) positions.push_back(column_named(heads, name));
  return positions;
}

std::string csv_text(const std::vector<Cells>& rows) {
  std::string csv;
  for (const Cells& row : rows) csv += csv_line(row) + "\n";
  return csv;
}

}  // namespace autoref::io
