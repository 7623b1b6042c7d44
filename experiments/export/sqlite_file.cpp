#include "experiments/export/sqlite_file.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <stdexcept>

#include "io/errors.hpp"

namespace autoref::experiments {
namespace {

[[noreturn]] void fail(sqlite3* database, int code) {
  const std::string why = database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code);
  const bool is_environment = code == SQLITE_NOMEM || code == SQLITE_FULL ||
                              code == SQLITE_TOOBIG || code == SQLITE_IOERR ||
                              code == SQLITE_CANTOPEN;
  if (is_environment) throw io::InputOutputError("cannot create the database: " + why);
  throw std::logic_error("SQLite: " + why);
}

std::string in_quotes(std::string_view text, char quote) {
  std::string quoted(1, quote);
  for (const char c : text) {
    if (c == quote) quoted += quote;
    quoted += c;
  }
  return quoted + quote;
}

// An SQL identifier.
std::string quoted_name(std::string_view name) { return in_quotes(name, '"'); }

struct Binding {
  sqlite3_stmt* statement;
  int index;  // index of the parameter, from 1

  int operator()(std::monostate) const { return sqlite3_bind_null(statement, index); }
  int operator()(std::int64_t number) const { return sqlite3_bind_int64(statement, index, number); }
  int operator()(double number) const { return sqlite3_bind_double(statement, index, number); }
  int operator()(const std::string& text) const {
    // No copy is needed, since the row outlives the step that reads it.
    return sqlite3_bind_text64(statement, index, text.data(), text.size(), nullptr, SQLITE_UTF8);
  }
};

SqliteValue value_at(sqlite3_stmt* statement, int column) {
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_NULL:
      return {};
    case SQLITE_INTEGER:
      return std::int64_t{sqlite3_column_int64(statement, column)};
    case SQLITE_FLOAT:
      return sqlite3_column_double(statement, column);
    default:
      return std::string(reinterpret_cast<const char*>(sqlite3_column_text(statement, column)),
                         static_cast<std::size_t>(sqlite3_column_bytes(statement, column)));
  }
}

}  // namespace

SqliteFile::SqliteFile() {
  const int code = sqlite3_open(":memory:", &database_);
  if (code == SQLITE_OK) return;
  sqlite3_close(database_);
  fail(nullptr, code);
}

SqliteFile::~SqliteFile() { sqlite3_close(database_); }

void SqliteFile::execute(const std::string& sql) {
  const int code = sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(database_, code);
}

void SqliteFile::add_rows(const std::vector<std::string>& tables, const std::string& file) {
  execute("ATTACH " + in_quotes(file, '\'') + " AS other");
  for (const std::string& table : tables) {
    const std::string name = quoted_name(table);
    execute(fmt::format("INSERT INTO main.{0} SELECT * FROM other.{0}", name));
  }
  execute("DETACH other");
}

void SqliteFile::each_row(const std::string& query,
                          const std::function<void(const SqliteRow&)>& use) const {
  sqlite3_stmt* prepared = nullptr;
  int code = sqlite3_prepare_v2(database_, query.c_str(), -1, &prepared, nullptr);
  if (code != SQLITE_OK) fail(database_, code);
  const std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> statement(prepared,
                                                                             &sqlite3_finalize);
  const int columns = sqlite3_column_count(prepared);
  SqliteRow row(static_cast<std::size_t>(columns));
  while ((code = sqlite3_step(prepared)) == SQLITE_ROW) {
    for (int i = 0; i < columns; ++i) row[static_cast<std::size_t>(i)] = value_at(prepared, i);
    use(row);
  }
  if (code != SQLITE_DONE) fail(database_, code);
}

std::string SqliteFile::bytes() const {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> image(
      sqlite3_serialize(database_, "main", &size, 0), &sqlite3_free);
  if (image == nullptr) fail(nullptr, SQLITE_NOMEM);
  return {reinterpret_cast<const char*>(image.get()), static_cast<std::size_t>(size)};
}

SqliteTable::SqliteTable(SqliteFile& file, std::string_view name,
                         const std::vector<SqliteColumn>& columns)
    : file_(file), columns_(columns.size()) {
  std::string names;
  std::string marks;
  for (const SqliteColumn& column : columns) {
    names += (names.empty() ? "" : ", ") + quoted_name(column.name);
    if (*column.type != '\0') names += std::string(" ") + column.type;
    marks += marks.empty() ? "?" : ", ?";
  }
  const std::string table = quoted_name(name);
  file.execute("CREATE TABLE " + table + " (" + names + ")");
  const std::string sql = "INSERT INTO " + table + " VALUES (" + marks + ")";
  const int code = sqlite3_prepare_v2(file.database_, sql.c_str(), -1, &insertion_, nullptr);
  if (code != SQLITE_OK) fail(file.database_, code);
}

SqliteTable::~SqliteTable() { sqlite3_finalize(insertion_); }

void SqliteTable::add(const SqliteRow& row) {
  if (row.size() != columns_) throw std::logic_error("a row of the wrong size");
  int index = 0;
  for (const SqliteValue& value : row) {
    const int code = std::visit(Binding{insertion_, ++index}, value);
    if (code != SQLITE_OK) fail(file_.database_, code);
  }
  const int code = sqlite3_step(insertion_);
  if (code != SQLITE_DONE) fail(file_.database_, code);
  sqlite3_reset(insertion_);
}

}  // namespace autoref::experiments
