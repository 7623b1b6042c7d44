#include "experiments/export/export_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/export/sqlite_file.hpp"
#include "game/loop/event_log.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::experiments {
namespace {

// What a database says of a value.
std::string cell_of(const io::Json& value) {
  if (value.is_null()) return "";
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  if (value.is_string()) return value.get<std::string>();
  return value.is_number() ? fmt::format("{:.9g}", value.get<double>()) : io::json_text(value);
}

// The rows of a query, their cells joined with '|'; NULL is empty.
std::vector<std::string> rows_of(const std::filesystem::path& file, const std::string& query) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  std::vector<std::string> rows;
  const auto add = [](void* all, int count, char** cells, char** /*names*/) {
    std::string row;
    for (int i = 0; i < count; ++i) {
      row += i > 0 ? "|" : "";
      row += cells[i] != nullptr ? cells[i] : "";
    }
    static_cast<std::vector<std::string>*>(all)->push_back(row);
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(database, query.c_str(), add, &rows, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  sqlite3_close(database);
  return rows;
}

class Export : public testing::Test {
 protected:
  void SetUp() override {
    write_content(folder_ / "short.yaml",
                  "schema: 1\nkind: sweep\nseed: 1\npairs: 1\n"
                  "base:\n  teams: { a: { strategy: basic }, b: { strategy: basic } }\n"
                  "  match: { rules: 2026-b, half_s: 20 }\n"
                  "factors: { b.robots: [6, 5] }\n");
    const std::string file = (folder_ / "short.yaml").string();
    ASSERT_EQ(app::answer_to({"run", file.c_str(), "-o", results_.c_str(), "-j", "1"}).code,
              io::kDone);
  }

  TemporaryFolder folder_;
  std::string results_ = (folder_ / "results").string();
  std::string database_ = (folder_ / "games.sqlite").string();
};

TEST_F(Export, WritesEveryGameWithTheRowsOfResults) {
  const app::Answer answer = app::answer_to(
      {"results", "export", results_.c_str(), "--sqlite", database_.c_str(), "--no-events"});
  ASSERT_EQ(answer.code, io::kDone);
  EXPECT_EQ(rows_of(database_, "SELECT name FROM sqlite_master ORDER BY name"),
            (std::vector<std::string>{"games", "settings"}));
  std::string csv;
  for (const std::string& row :
       rows_of(database_,
               "SELECT game_id, pair, leg, \"b.robots\", team_a, team_b, side_a, seed "
               "FROM games"))
    csv += row + "\n";
  std::replace(csv.begin(), csv.end(), '|', ',');
  const std::string results = content_of(folder_ / "results/results.csv");
  for (std::size_t line = 0; line < csv.size(); line = csv.find('\n', line) + 1) {
    const std::string start = csv.substr(line, csv.find('\n', line) - line);
    EXPECT_NE(results.find("\n" + start + ","), std::string::npos) << start;
  }
  EXPECT_EQ(rows_of(database_,
                    "SELECT count(*), sum(typeof(goals_a) = 'integer'), "
                    "sum(typeof(state_hash) = 'text') FROM games"),
            std::vector<std::string>{"4|4|4"});
}

TEST_F(Export, WritesSettingsByPath) {
  app::answer_to(
      {"results", "export", results_.c_str(), "--sqlite", database_.c_str(), "--no-events"});
  EXPECT_EQ(rows_of(database_,
                    "SELECT value, typeof(value) FROM settings WHERE setting IN "
                    "('base.match.rules', 'pairs', 'base.match.half_s') ORDER BY 1"),
            (std::vector<std::string>{"1|integer", "20.0|real", "2026-b|text"}));
}

TEST_F(Export, WritesTheEventsOfEachGame) {
  ASSERT_EQ(app::answer_to(
                {"results", "export", results_.c_str(), "--sqlite", database_.c_str(), "-j", "2"})
                .code,
            io::kDone);
  const std::string log = (folder_ / "events.jsonl").string();
  ASSERT_EQ(app::answer_to({"results", "replay", results_.c_str(), "b.robots=5-p0001-2", "--events",
                            log.c_str()})
                .code,
            io::kDone);
  const std::string lines = content_of(log);
  const auto count = std::count(lines.begin(), lines.end(), '\n');
  EXPECT_EQ(rows_of(database_,
                    "SELECT count(*), max(number), min(time_s) >= 0 FROM events WHERE "
                    "game_id = 'b.robots=5-p0001-2'"),
            std::vector<std::string>{std::to_string(count) + "|" + std::to_string(count) + "|1"});
  for (const std::string& evidence :
       rows_of(database_,
               "SELECT evidence FROM events WHERE game_id = 'b.robots=5-p0001-2' AND "
               "evidence IS NOT NULL"))
    EXPECT_NE(lines.find(evidence), std::string::npos) << evidence;
}

TEST_F(Export, HasTheValuesOfTheEventLog) {
  const std::string log = (folder_ / "events.jsonl").string();
  app::answer_to({"results", "export", results_.c_str(), "--sqlite", database_.c_str()});
  app::answer_to(
      {"results", "replay", results_.c_str(), "b.robots=5-p0001-2", "--events", log.c_str()});
  const std::string text = content_of(log);
  for (const game::DecisionField& field : game::decision_fields()) {
    const std::string column = game::column_of(field);
    if (column.empty()) continue;
    std::vector<std::string> logged;
    for (const std::string_view line : io::complete_lines(text))
      logged.push_back(
          cell_of(io::Json::parse(line).value(io::Json::json_pointer(field.path), io::Json())));
    const bool is_real = field.type == std::string_view("REAL");
    const std::string cell = is_real ? "printf('%.9g', " + column + ")" : column;
    EXPECT_EQ(rows_of(database_, fmt::format("SELECT iif({0} IS NULL, NULL, {1}) FROM events WHERE "
                                             "game_id = 'b.robots=5-p0001-2' ORDER BY number",
                                             column, cell)),
              logged)
        << column;
  }
}

// The first cells of a CSV file's rows, joined with '|'.
std::vector<std::string> first_cells_of(const std::filesystem::path& file, std::size_t count) {
  const std::string text = content_of(file);
  std::vector<std::string> rows;
  for (const std::string_view line : io::complete_lines(text)) {
    const io::Cells cells = io::csv_cells(line).value();
    rows.push_back(fmt::format(
        "{}", fmt::join(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(count), "|")));
  }
  rows.erase(rows.begin());
  return rows;
}

TEST_F(Export, HasTheChainsAndActionsOfTheFilesOfAReplay) {
  const std::string id = "b.robots=6-p0001-1";
  app::answer_to({"results", "export", results_.c_str(), "--sqlite", database_.c_str()});
  const std::string chains = (folder_ / "chains.csv").string();
  const std::string actions = (folder_ / "actions.csv").string();
  app::answer_to({"results", "replay", results_.c_str(), id.c_str(), "--chains", chains.c_str(),
                  "--actions", actions.c_str()});
  const auto rows = [&](const std::string& columns, const std::string& table) {
    return rows_of(database_, fmt::format("SELECT {} FROM {} WHERE game_id = '{}' ORDER BY rowid",
                                          columns, table, id));
  };
  const std::vector<std::string> stored = rows("number, team, start, end", "chains");
  EXPECT_GT(stored.size(), 3U);
  EXPECT_EQ(stored, first_cells_of(chains, 4));
  EXPECT_EQ(rows("team, robot, action, printf('%.4f', start_s)", "actions"),
            first_cells_of(actions, 4));
}

TEST_F(Export, HasTheShotsOfTheChainsAndRows) {
  app::answer_to({"results", "export", results_.c_str(), "--sqlite", database_.c_str()});
  const std::vector<std::string> shots = rows_of(database_, "SELECT count(*) FROM shots");
  EXPECT_NE(shots, std::vector<std::string>{"0"});
  EXPECT_EQ(rows_of(database_, "SELECT sum(shots) FROM chains"), shots);
  EXPECT_EQ(rows_of(database_, "SELECT sum(shots_a + shots_b) FROM games"), shots);
  EXPECT_EQ(rows_of(database_,
                    "SELECT game_id, team, printf('%.6f', sum(xg)) FROM shots "
                    "GROUP BY 1, 2"),
            rows_of(database_,
                    "SELECT game_id, team, printf('%.6f', sum(xg)) FROM chains "
                    "GROUP BY 1, 2 HAVING sum(shots) > 0"));
}

TEST_F(Export, RepeatsByteForByte) {
  const std::string again = (folder_ / "again.sqlite").string();
  app::answer_to({"results", "export", results_.c_str(), "--sqlite", database_.c_str(), "-j", "2"});
  app::answer_to({"results", "export", results_.c_str(), "--sqlite", again.c_str(), "-j", "1"});
  EXPECT_EQ(content_of(database_), content_of(again));
}

TEST_F(Export, DeclaresTheTypesOfColumns) {
  app::answer_to({"results", "export", results_.c_str(), "--sqlite", database_.c_str()});
  EXPECT_EQ(rows_of(database_,
                    "SELECT name, type FROM pragma_table_info('games') WHERE name IN "
                    "('game_id', 'goals_a', 'sim_s', 'state_hash') ORDER BY 1"),
            (std::vector<std::string>{"game_id|TEXT", "goals_a|INTEGER", "sim_s|REAL",
                                      "state_hash|TEXT"}));
  EXPECT_EQ(rows_of(database_,
                    "SELECT name, type FROM pragma_table_info('events') WHERE name IN "
                    "('event', 'score_blue', 'time_s') ORDER BY 1"),
            (std::vector<std::string>{"event|TEXT", "score_blue|INTEGER", "time_s|REAL"}));
}

TEST_F(Export, ReplacesAnExistingFileOnlyOnRequest) {
  write_content(database_, "precious");
  const app::Answer refused = app::answer_to(
      {"results", "export", results_.c_str(), "--sqlite", database_.c_str(), "--no-events"});
  EXPECT_EQ(refused.code, io::kBadInput);
  EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
  EXPECT_EQ(content_of(database_), "precious");
  EXPECT_EQ(app::answer_to({"results", "export", results_.c_str(), "--sqlite", database_.c_str(),
                            "--no-events", "--force"})
                .code,
            io::kDone);
  EXPECT_EQ(rows_of(database_, "SELECT count(*) FROM games"), std::vector<std::string>{"4"});
}

TEST_F(Export, LeavesAnExistingFileAloneIfItFails) {
  write_content(database_, "precious");
  const app::Answer answer = app::answer_to(
      {"results", "export", (folder_ / "nowhere").c_str(), "--sqlite", database_.c_str()});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_EQ(content_of(database_), "precious");
}

TEST(SqliteFile, AddsTheRowsOfAnotherFile) {
  const TemporaryFolder folder;
  SqliteFile other;
  SqliteTable(other, "t", {{"x", "REAL"}}).add({0.5});
  write_content(folder / "it's.sqlite", other.bytes());
  SqliteFile file;
  SqliteTable(file, "t", {{"x", "REAL"}}).add({std::monostate()});
  file.add_rows({"t"}, (folder / "it's.sqlite").string());
  file.add_rows({"t"}, (folder / "it's.sqlite").string());
  write_content(folder / "both.sqlite", file.bytes());
  EXPECT_EQ(rows_of(folder / "both.sqlite", "SELECT x FROM t"),
            (std::vector<std::string>{"", "0.5", "0.5"}));
  EXPECT_THROW(file.add_rows({"t"}, (folder / "nowhere/t.sqlite").string()), io::InputOutputError);
}

TEST(SqliteFile, KeepsNamesAndTextsWithQuotes) {
  const TemporaryFolder folder;
  SqliteFile file;
  SqliteTable table(file, "a \"b\"", {{"it's"}, {"b.robots=\"x\""}});
  table.add({std::string("'; DROP TABLE"), std::monostate()});
  write_content(folder / "quoted.sqlite", file.bytes());
  EXPECT_EQ(rows_of(folder / "quoted.sqlite", "SELECT * FROM \"a \"\"b\"\"\""),
            std::vector<std::string>{"'; DROP TABLE|"});
  EXPECT_THROW(table.add({std::monostate()}), std::logic_error);
}

}  // namespace
}  // namespace autoref::experiments
