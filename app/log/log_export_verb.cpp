#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

#include "app/log/judged_log.hpp"
#include "app/output_file.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/table_columns.hpp"
#include "logs/log_tables.hpp"
#include "logs/user_log.hpp"

namespace autoref::app {
namespace {

const std::vector<std::string> kTables = {"tracks", "chains", "actions", "shots"};

struct LogExportArguments {
  std::vector<std::string> logs;
  std::string folder;
  std::vector<std::string> what = kTables;
  std::string rules;      // empty: guessed
  bool replaces = false;  // whether to replace existing files
};

// A CSV file of the folder; nothing is written unless it is wanted.
template <typename Row>
class ExportedTable {
 public:
  ExportedTable(const LogExportArguments& arguments, const std::string& name,
                io::TableColumns<Row> columns)
      : path_(path_of(arguments, name)), columns_(std::move(columns)), file_("-o", path_) {
    if (file_.is_open()) file_.add(io::csv_line(io::heads_of(columns_)));
  }

  void add(const Row& row) {
    if (!file_.is_open()) return;
    file_.add(io::csv_line(io::cells_of(columns_, row)));
    ++rows_;
  }
  void commit() {
    if (!file_.is_open()) return;
    file_.commit();
    fmt::print("{}   {} rows\n", path_, rows_);
  }

 private:
  static std::string path_of(const LogExportArguments& arguments, const std::string& name) {
    const auto& what = arguments.what;
    if (std::find(what.begin(), what.end(), name) == what.end()) return "";
    std::string path = (std::filesystem::path(arguments.folder) / (name + ".csv")).string();
    std::error_code none;
    if (std::filesystem::exists(path, none) && !arguments.replaces)
      throw io::InputError({"-o"}, "", fmt::format("{} exists; replace it with --force", path));
    return path;
  }

  std::string path_;
  io::TableColumns<Row> columns_;
  LineOutput file_;
  std::int64_t rows_ = 0;
};

void create_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw io::InputError({"-o"}, "", fmt::format("{}: {}", folder, error.message()));
}

int log_export_verb(const LogExportArguments& arguments) {
  const std::vector<std::string> paths = logs::logs_in(arguments.logs);
  create_folder(arguments.folder);
  ExportedTable tracks(arguments, "tracks", logs::track_columns());
  ExportedTable chains(arguments, "chains", logs::logged_chain_columns());
  ExportedTable actions(arguments, "actions", logs::logged_action_columns());
  ExportedTable shots(arguments, "shots", logs::logged_shot_columns());
  const int code = for_each_log(paths, [&](const std::string& path) {
    const JudgedLog judged =
        judged_log(path, arguments.rules, [&](const logs::LogReferee& referee) {
          for (const logs::TrackRow& row : logs::track_rows(path, referee)) tracks.add(row);
        });
    int number = 0;
    for (const game::PossessionChain& chain : judged.result.play.chains)
      chains.add({path, {++number, chain}});
    for (const logs::RecordedAction& action : judged.result.play.actions)
      actions.add({path, action.action});
    for (const logs::RecordedShot& shot : judged.result.play.shots) shots.add({path, shot.shot});
    return !judged.facts.log.damage;
  });
  tracks.commit();
  chains.commit();
  actions.commit();
  shots.commit();
  return code;
}

}  // namespace

void add_log_export_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "export", "Write tracks, possession chains, actions and shots of logs as CSV.");
  auto arguments = std::make_shared<LogExportArguments>();
  add_logs_argument(*verb, arguments->logs);
  verb->add_option("-o,--output", arguments->folder, "Folder for the files; created if missing.")
      ->type_name("DIR")
      ->required();
  verb->add_option("--what", arguments->what, "Tables to write, separated by commas.")
      ->delimiter(',')
      ->check(one_of(kTables))
      ->capture_default_str();
  verb->add_option("--rules", arguments->rules, "Rule book; guessed from each log by default.")
      ->type_name("BOOK");
  verb->add_flag("--force", arguments->replaces, "Replace existing files.");
  verb->footer(
      "Writes tracks.csv (a row per object and frame, about 40 MB for ten minutes), chains.csv,\n"
      "actions.csv and shots.csv; docs/schemas.md describes their columns. A damaged log is\n"
      "exported up to the damage, and the exit code is 2.\n\n"
      "Example:\n  autoref log export recordings/ -o tables --what chains,shots");
  choose(*verb, chosen, arguments, log_export_verb);
}

}  // namespace autoref::app
