#include "app/experiment/played_experiment.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/experiment/shown_run.hpp"
#include "app/shared_options.hpp"
#include "experiments/report/folder_report.hpp"
#include "experiments/run/program_versions.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"
#include "io/terminal.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

experiments::ExperimentOptions options_of(const RunArguments& arguments,
                                          const experiments::Experiment& experiment) {
  experiments::ExperimentOptions options;
  options.folder = arguments.results_folder();
  options.build = io::build_id();
  options.workers = worker_count(arguments.workers);
  try {
    options.shard = experiments::shard_index_of(arguments.shard);
  } catch (const std::invalid_argument& error) {
    throw io::InputError({"--shard"}, "", error.what());
  }
  options.allow_mixed_build = arguments.allow_mixed_build;
  options.reused_folder = arguments.reused_folder;
  options.wait_s = arguments.wait_s.value_or(experiment.default_wait_s());
  options.play = [folder = options.folder](const game::GameConfiguration& game) {
    return experiments::play_live(game, folder);
  };
  options.progress = arguments.quiet ? nullptr : stderr;
  if (!arguments.progress.empty())
    options.style = io::progress_style_of(arguments.progress).value();
  return options;
}

// Prints what follows the tables.
void print_files(const experiments::ExperimentReport& report, const fs::path& folder) {
  print_rule_notes(report);
  fmt::print("{}   one row per game\n", (folder / "results.csv").string());
  for (const experiments::ResultFile& file : report.results.files) {
    fmt::print("{}   {}\n", (folder / file.name).string(), file.about);
  }
  fmt::print("{}   all settings\n", (folder / "effective.yaml").string());
  if (report.unrepeatable_games > 0) {
    fmt::print(
        "\n{} games are not repeatable: their programs sent other commands when started again; "
        "autoref results verify and replay use the recorded ones\n",
        report.unrepeatable_games);
  }
  if (report.killed_games == 0) return;
  fmt::print(
      "\n{} games are void because their workers were killed; repeat the command to play them "
      "again\n",
      report.killed_games);
}

// Prints the outcome of a run that was not interrupted.
void print_end(const experiments::Scenario& scenario, const experiments::ExperimentReport& report,
               const experiments::ExperimentOptions& options, const PrintTables& print_tables) {
  const std::string folder = options.folder.string();
  if (report.is_complete) {
    print_tables(report);
    print_files(report, options.folder);
  } else if (report.is_waiting && scenario.experiment().games_of_a_round()) {
    fmt::print("{} of {} games are in {}; the next ones depend on {}; repeat the command{}\n",
               report.done, report.games, folder,
               report.killed_games > 0 ? fmt::format("{} games that are void because their workers "
                                                     "were killed",
                                                     report.killed_games)
                                       : "games of other shards",
               report.killed_games > 0 ? " to play those again" : " once those are done");
  } else if (report.is_waiting) {
    fmt::print(
        "shard {} has played all ties known so far: {} of {} games are in {}; later ties depend on "
        "games "
        "of other shards; repeat the command once those are done\n",
        options.shard.name(), report.done, report.games, folder);
  } else {
    fmt::print(
        "shard {} is done: {} of {} games are in {}; once all are done, merge them with: "
        "autoref report {}\n",
        options.shard.name(), report.done, report.games, folder, folder);
  }
}

// Handles an existing report, which may cover fewer games: a complete run updates it; an incomplete
// run only lists what is missing. Returns the line to print, if any.
std::string mended_report(const experiments::ExperimentReport& report,
                          const experiments::ExperimentOptions& options) {
  if (report.done == 0 || !fs::exists(options.folder / experiments::kMarkdownReport)) return {};
  const experiments::ResultFolder folder = experiments::open_results(options.folder, options.build);
  if (!report.is_complete) {
    const std::string shortfall = experiments::report_shortfall(folder);
    return shortfall.empty() ? "" : shortfall + "\n";
  }
  const fs::path written = experiments::refresh_report(folder);
  return written.empty() ? "" : fmt::format("{}   updated\n", written.string());
}

int exit_code_of(const experiments::Scenario& scenario,
                 const experiments::ExperimentReport& report) {
  if (report.is_interrupted) return io::kInterrupted;
  if (report.is_waiting && scenario.experiment().games_of_a_round()) return io::kInterrupted;
  if (!report.is_complete || report.void_games <= io::kMostVoid * report.games) return io::kDone;
  return io::kTooManyVoid;
}

}  // namespace

void add_run_options(CLI::App& verb, RunArguments& arguments) {
  verb.add_option("--shard", arguments.shard,
                  "Play only shard I (from 0) of N; other runs play the rest.")
      ->type_name("I/N");
  verb.add_flag("--allow-mixed-build", arguments.allow_mixed_build,
                "Continue in a folder that holds games of another build; those do not count.");
  verb.add_option(
          "--progress", arguments.progress,
          "Progress on stderr: plain text lines, JSON lines, or none. Default: a table on a "
          "terminal, otherwise plain.")
      ->type_name("STYLE")
      ->check(one_of({"plain", "json", "none"}));
  add_web_flags(verb, arguments.web,
                "Show results and games in browsers, at this address of this computer, such as "
                "127.0.0.1:8090; without an address, only for browsers on this computer.");
  verb.add_flag("--quiet", arguments.quiet,
                "Print only errors; check the exit code for the outcome.")
      ->excludes("--progress");
}

PlayedExperiment play_experiment(const experiments::Scenario& scenario,
                                 const RunArguments& arguments, const PrintTables& print_tables) {
  experiments::ExperimentOptions options = options_of(arguments, scenario.experiment());
  ShownRun shown(scenario, fs::path(arguments.file).stem().string(), arguments.web, options);
  PlayedExperiment played{0, experiments::run_experiment(scenario, options)};
  const experiments::ExperimentReport& report = played.report;
  played.exit_code = exit_code_of(scenario, report);
  shown.end();
  const std::string about_report = mended_report(report, options);
  if (report.is_interrupted) {
    io::write_message(
        stderr,
        fmt::format(
            "autoref: interrupted with {} of {} games done; repeat the command to continue\n",
            report.done, report.games) +
            about_report);
    return played;
  }
  if (arguments.json) {
    if (report.is_complete) print_tables(report);
  } else if (!arguments.quiet) {
    print_end(scenario, report, options, print_tables);
    fmt::print("{}", about_report);
  }
  if (played.exit_code != io::kTooManyVoid) return played;
  io::write_message(
      stderr,
      fmt::format("autoref: {} of {} games are void; see the column void_reason of {}\n",
                  report.void_games, report.games, (options.folder / "results.csv").string()));
  return played;
}

}  // namespace autoref::app
