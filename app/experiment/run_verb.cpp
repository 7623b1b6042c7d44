#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/experiment/batch_arguments.hpp"
#include "app/experiment/shown_run.hpp"
#include "app/network_flags.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/kinds/all_kinds.hpp"
#include "experiments/report/folder_report.hpp"
#include "experiments/run/program_versions.hpp"
#include "experiments/run/run_experiment.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"
#include "io/terminal.hpp"

namespace autoref::app {
namespace {

struct RunArguments : BatchArguments {
  std::string shard = "0/1";
  bool allow_mixed_build = false;
  bool quiet = false;
  std::string progress;          // "plain", "json" or "none"; empty: depends on the stream
  WebFlags web;                  // where to show the standings on the network
  std::optional<double> wait_s;  // maximum wait for games of other shards
};

namespace fs = std::filesystem;

constexpr double kLongestWait_s = 86400;

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
  options.wait_s = arguments.wait_s.value_or(experiment.default_wait_s());
  options.play = [folder = options.folder](const game::GameConfiguration& game) {
    return experiments::play_live(game, folder);
  };
  options.progress = arguments.quiet ? nullptr : stderr;
  if (!arguments.progress.empty())
    options.style = io::progress_style_of(arguments.progress).value();
  return options;
}

void print_results(const experiments::Scenario& scenario,
                   const experiments::ExperimentReport& report, const fs::path& folder) {
  const std::size_t width = io::text_width(stdout);
  if (!scenario.about.empty()) fmt::print("{}\n\n", io::wrapped(scenario.about, width));
  fmt::print("{}\n", io::text_of(report.results.table, width));
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
               const experiments::ExperimentOptions& options) {
  const std::string folder = options.folder.string();
  if (report.is_complete) return print_results(scenario, report, options.folder);
  if (report.is_waiting && scenario.experiment().games_of_a_round()) {
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

int run_verb(const RunArguments& arguments) {
  const experiments::Scenario scenario = read_experiment(arguments);
  experiments::ExperimentOptions options = options_of(arguments, scenario.experiment());
  ShownRun shown(scenario, std::filesystem::path(arguments.file).stem().string(), arguments.web,
                 options);
  const experiments::ExperimentReport report = experiments::run_experiment(scenario, options);
  shown.end();
  const std::string about_report = mended_report(report, options);
  if (report.is_interrupted) {
    io::write_message(
        stderr,
        fmt::format(
            "autoref: interrupted with {} of {} games done; repeat the command to continue\n",
            report.done, report.games) +
            about_report);
    return io::kInterrupted;
  }
  if (!arguments.quiet) {
    print_end(scenario, report, options);
    fmt::print("{}", about_report);
  }
  if (report.is_waiting && scenario.experiment().games_of_a_round()) return io::kInterrupted;
  if (!report.is_complete || report.void_games <= io::kMostVoid * report.games) return io::kDone;
  io::write_message(
      stderr,
      fmt::format("autoref: {} of {} games are void; see the column void_reason of {}\n",
                  report.void_games, report.games, (options.folder / "results.csv").string()));
  return io::kTooManyVoid;
}

// "600 for kind tune, "
std::string default_waits() {
  std::string text;
  for (const experiments::Kind* kind : experiments::kinds_of_experiments()) {
    const double wait_s = kind->make()->default_wait_s();
    if (wait_s > 0) text += fmt::format("{} for kind {}, ", wait_s, kind->name);
  }
  return text;
}

void add_run_options(CLI::App& verb, RunArguments& arguments) {
  add_experiment_argument(verb, arguments, "run");
  add_batch_options(verb, arguments);
  add_override_options(verb, arguments);
  verb.add_option("--shard", arguments.shard,
                  "Play only shard I (from 0) of N; other runs play the rest.")
      ->type_name("I/N");
  verb.add_option("--wait", arguments.wait_s,
                  "How long a shard waits, in s, for games of other shards that its own next games "
                  "depend on. Default: " +
                      default_waits() + "otherwise 0.")
      ->type_name("S")
      ->check(CLI::Range(0.0, kLongestWait_s));
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

}  // namespace

void add_run_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("run", "Run an experiment: a sweep, a tournament, a match or a tuning.");
  auto arguments = std::make_shared<RunArguments>();
  add_run_options(*verb, *arguments);
  verb->footer(
      "Ctrl-C lets the running games finish; a second one stops them immediately. Repeat the same\n"
      "command to continue: games whose workers were killed are played again. You can continue\n"
      "with more pairs in the same folder; with fewer, the surplus rows do not count. Another\n"
      "seed needs another folder. An existing report is updated when all games are done.\n\n"
      "Shards may share a folder, or each use its own; then copy all games/*.csv into one folder\n"
      "for autoref report. An SPRT match ends with the pair of games that decides it; shards with\n"
      "separate folders play all pairs up to the maximum. A shard of a knockout, a Swiss\n"
      "tournament or a tuning needs games of the others, in the same folder. It waits for them\n"
      "as long as --wait allows, then ends (with code 75, or 0 for a knockout); the same command\n"
      "continues.\n\n"
      "A tuning searches for better parameters of a team with SPSA or CMA-ES, then tests the\n"
      "result against the start with new games and says whether it is better. It writes\n"
      "tune.csv, the path of every parameter, and result.yaml, the tuned team. The path does not\n"
      "depend on the number of workers or shards; autoref report draws it.\n\n"
      "--progress json prints one object per line on stderr, every 5 s and at the end, with event\n"
      "(progress, end, or note with a text), done, total, void, played (by this run), elapsed_s,\n"
      "games_per_min, left_s and, depending on the kind, standings, groups, sprt, ties or\n"
      "situations, with the columns of the CSV files.\n\n"
      "Examples:\n  autoref run scenarios/handicap-speed.yaml -o results/runs/speed -j 2\n"
      "  autoref run scenarios/tune-first.yaml -o results/runs/tune");
  choose(*verb, chosen, arguments, run_verb);
}

}  // namespace autoref::app
