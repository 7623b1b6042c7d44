// A SQLite database, built in memory. The only file that uses SQLite is sqlite_file.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace autoref::experiments {

// NULL, an integer, a real number or a text.
using SqliteValue = std::variant<std::monostate, std::int64_t, double, std::string>;
using SqliteRow = std::vector<SqliteValue>;

class SqliteFile {
 public:
  SqliteFile();
  ~SqliteFile();
  SqliteFile(const SqliteFile&) = delete;
  SqliteFile& operator=(const SqliteFile&) = delete;

  // Runs SQL statements that return no rows. Throws std::logic_error if a statement is invalid, and
  // InputOutputError if memory runs out. All functions below throw like this.
  void execute(const std::string& sql);

  // Adds to each of the tables the rows of the same table in a database file. Must not be called
  // within a transaction. Also throws InputOutputError if the file cannot be read.
  void add_rows(const std::vector<std::string>& tables, const std::string& file);

  // Calls `use` for each row of a query's answer.
  void each_row(const std::string& query, const std::function<void(const SqliteRow&)>& use) const;

  // The content of the database file. The same sequence of calls gives the same bytes.
  std::string bytes() const;

 private:
  friend class SqliteTable;
  sqlite3* database_ = nullptr;
};

struct SqliteColumn {
  std::string name;
  const char* type = "";  // INTEGER, REAL or TEXT; empty: each value keeps its own type
};

// A new table in a SQLite database.
class SqliteTable {
 public:
  // The names of `columns` must differ by more than case. `file` must outlive this object.
  SqliteTable(SqliteFile& file, std::string_view name, const std::vector<SqliteColumn>& columns);
  ~SqliteTable();
  SqliteTable(const SqliteTable&) = delete;
  SqliteTable& operator=(const SqliteTable&) = delete;

  // Adds a row, with one value per column.
  void add(const SqliteRow& row);

 private:
  SqliteFile& file_;
  std::size_t columns_;
  sqlite3_stmt* insertion_ = nullptr;
};

}  // namespace autoref::experiments
