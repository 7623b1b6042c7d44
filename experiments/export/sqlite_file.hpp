// A SQLite database, built in memory. The only file that uses SQLite is sqlite_file.cpp.
#pragma once

#include <cstdint>
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

class SqliteFile {
 public:
  SqliteFile();
  ~SqliteFile();
  SqliteFile(const SqliteFile&) = delete;
  SqliteFile& operator=(const SqliteFile&) = delete;

  // Runs SQL statements that return no rows. Throws std::logic_error if they are wrong, and
  // InputOutputError if memory runs out; so do all functions below.
  void execute(const std::string& sql);

  // Adds to `table` the rows of the same table in another database, a file. Not within a
  // transaction. Throws InputOutputError also if the file cannot be read.
  void add_rows(std::string_view table, const std::string& file);

  // The database as a file. The same calls give the same bytes.
  std::string bytes() const;

 private:
  friend class SqliteTable;
  sqlite3* database_ = nullptr;
};

struct SqliteColumn {
  std::string name;
  const char* type = "";  // INTEGER, REAL or TEXT; without one, each value keeps its own
};

// A new table.
class SqliteTable {
 public:
  // `columns` must be different from each other, also in lower case. The file must outlive this
  // object.
  SqliteTable(SqliteFile& file, std::string_view name, const std::vector<SqliteColumn>& columns);
  ~SqliteTable();
  SqliteTable(const SqliteTable&) = delete;
  SqliteTable& operator=(const SqliteTable&) = delete;

  // Adds a row of as many values as there are columns.
  void add(const std::vector<SqliteValue>& row);

 private:
  SqliteFile& file_;
  std::size_t columns_;
  sqlite3_stmt* insertion_ = nullptr;
};

}  // namespace autoref::experiments
