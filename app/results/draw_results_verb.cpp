#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/results/folder_arguments.hpp"
#include "app/results/judged_results.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/export/play_drawings.hpp"
#include "experiments/report/folder_report.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/terminal.hpp"

namespace autoref::app {
namespace {

struct DrawResultsArguments : FolderArguments {
  std::vector<std::string> teams;  // empty: all
  int workers = 0;                 // 0: one per processor
};

namespace fs = std::filesystem;

// Prints where the drawings are shown.
io::ExitCode print_report(const experiments::FolderReport& written, const std::string& drawn_rows) {
  if (!written.report) {
    io::write_message(stderr, fmt::format("autoref: the report was not written, since it would "
                                          "lose games; see autoref report {}\n",
                                          written.folder.path.string()));
    return io::kDifferent;
  }
  if (experiments::rows_checksum(written.folder) == drawn_rows)
    fmt::print("{}   the report, with the drawings\n",
               (written.into / experiments::kHtmlReport).string());
  return io::kDone;
}

int draw_results_verb(const DrawResultsArguments& arguments) {
  if (is_judged(experiments::scenario_in(arguments.folder)))
    throw io::InputError({arguments.folder}, "",
                         "holds judged games; the verb draws the games of autoref run and compare");
  const experiments::ResultFolder folder =
      experiments::open_results(arguments.folder, arguments.build);
  const bool has_builds = experiments::builds_in(arguments.folder).size() > 1;
  const fs::path into =
      has_builds ? experiments::build_folder(folder.path, folder.build) : folder.path;
  io::create_folder(into);
  // Fails now if the folder cannot be written to, rather than after the replays.
  { const io::PendingFile trial(into / experiments::kMarkdownReport); }
  const std::vector<experiments::ResultDrawing> drawings = experiments::play_drawings(
      folder, {worker_count(arguments.workers), stderr}, arguments.teams);
  experiments::store_play_drawings(folder, drawings, into);
  for (const experiments::ResultDrawing& drawing : drawings)
    fmt::print("{}   {}\n", (into / drawing.name).string(), drawing.caption);
  io::ExitCode code = io::kDone;
  for (const experiments::FolderReport& written :
       experiments::write_folder_reports(folder.path, has_builds ? "" : folder.build)) {
    if (written.folder.build == folder.build)
      code = print_report(written, experiments::rows_checksum(folder));
  }
  return code;
}

}  // namespace

void add_draw_results_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "draw",
      "Draw where the teams shot, began chains and lost the ball, over all games of a folder.");
  auto arguments = std::make_shared<DrawResultsArguments>();
  add_folder_options(*verb, *arguments);
  verb->add_option("--teams", arguments->teams, "Draw only these teams.")
      ->delimiter(',')
      ->type_name("A,B,...");
  add_workers_option(*verb, arguments->workers);
  verb->footer(
      "Plays the games again, since results do not contain what happened in them. Writes\n"
      "DIR/shots.svg, DIR/chains.svg and DIR/losses.svg, and adds them to the report.\n\n"
      "Example:\n  autoref results draw results/runs/first-look");
  choose(*verb, chosen, arguments, draw_results_verb);
}

}  // namespace autoref::app
