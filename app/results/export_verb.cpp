#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/output_file.hpp"
#include "app/results/folder_arguments.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/export/export_folder.hpp"
#include "experiments/run/result_folder.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

struct ExportArguments : FolderArguments {
  std::string sqlite;
  bool is_without_replays = false;
  bool replaces = false;  // whether to replace an existing file
  int workers = 0;        // 0: one per processor
};

int export_verb(const ExportArguments& arguments) {
  check_outputs({{"--sqlite", arguments.sqlite}}, experiments::files_of_results(arguments.folder));
  const experiments::ResultFolder folder =
      experiments::open_results(arguments.folder, arguments.build);
  std::optional<io::PendingFile> file;
  if (std::filesystem::is_regular_file(arguments.sqlite) && !arguments.replaces) {
    throw io::InputError({"--sqlite"}, "",
                         fmt::format("{} exists; replace it with --force", arguments.sqlite));
  }
  open_output(file, "--sqlite", arguments.sqlite);
  std::optional<experiments::ReplayOptions> replays;
  if (!arguments.is_without_replays)
    replays = {worker_count(arguments.workers), stderr, ", or leave it out with --no-events"};
  const std::string database = experiments::exported(folder, replays);
  file->commit(database);
  fmt::print("{}   {} games, {:.1f} MB\n", arguments.sqlite, folder.completed_games.done.size(),
             static_cast<double>(database.size()) / 1e6);
  return io::kDone;
}

}  // namespace

void add_export_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "export", "Write the games of a results folder, and what happened in them, into a database.");
  auto arguments = std::make_shared<ExportArguments>();
  add_folder_options(*verb, *arguments);
  verb->add_option("--sqlite", arguments->sqlite, "The database, a SQLite file.")
      ->type_name("FILE")
      ->required();
  verb->add_flag("--no-events", arguments->is_without_replays,
                 "Write only games and settings. The other tables (events, chains, actions, shots) "
                 "require playing every game again.");
  verb->add_flag("--force", arguments->replaces, "Replace an existing file.");
  add_workers_option(*verb, arguments->workers);
  verb->footer(
      "docs/schemas.md describes the tables.\n\n"
      "Example:\n  autoref results export results/runs/first-look --sqlite games.sqlite\n"
      "  sqlite3 games.sqlite \"SELECT event, count(*) FROM events GROUP BY event\"");
  choose(*verb, chosen, arguments, export_verb);
}

}  // namespace autoref::app
