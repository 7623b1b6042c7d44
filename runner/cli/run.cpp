#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "runner/batch/experiment.hpp"
#include "runner/cli/command_line.hpp"
#include "runner/io/build_id.hpp"
#include "runner/io/errors.hpp"
#include "runner/report/folder_report.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

ExperimentOptions options_of(const RunArguments& arguments) {
  ExperimentOptions options;
  options.folder = arguments.results_folder();
  options.build = build_id();
  options.workers = arguments.worker_count();
  try {
    options.shard = shard_index_of(arguments.shard);
  } catch (const std::invalid_argument& error) {
    throw InputError({"--shard"}, "", error.what());
  }
  options.allow_mixed_build = arguments.allow_mixed_build;
  options.play = [](const GameConfiguration& game) { return play(game); };
  options.progress = arguments.quiet ? nullptr : stderr;
  if (!arguments.progress.empty()) options.style = progress_style_of(arguments.progress).value();
  return options;
}

void print_results(const Scenario& scenario, const ExperimentReport& report,
                   const fs::path& folder) {
  if (!scenario.about.empty()) fmt::print("{}\n\n", scenario.about);
  fmt::print("{}\n", report.results.table);
  const std::vector<std::string>& never = report.transitions_never_used;
  fmt::print("referee transitions never used in {} games: {}\n\n", report.games,
             never.empty() ? "none" : fmt::format("{}", fmt::join(never, ", ")));
  fmt::print("{}   a row per game\n", (folder / "results.csv").string());
  for (const ResultFile& file : report.results.files) {
    fmt::print("{}   {}\n", (folder / file.name).string(), file.about);
  }
  fmt::print("{}   every setting\n", (folder / "effective.yaml").string());
  if (report.killed_games == 0) return;
  fmt::print(
      "\n{} games are void because their workers were killed; the same command plays them "
      "again\n",
      report.killed_games);
}

// What a run that was not interrupted has come to.
void print_end(const Scenario& scenario, const ExperimentReport& report,
               const ExperimentOptions& options) {
  const std::string folder = options.folder.string();
  if (report.is_complete) return print_results(scenario, report, options.folder);
  if (report.is_waiting) {
    fmt::print(
        "shard {} has played what is known: {} of {} games are in {}; later ties follow from games "
        "of other shards: when these are there, the same command goes on\n",
        options.shard.name(), report.done, report.games, folder);
  } else {
    fmt::print(
        "shard {} is done: {} of {} games are in {}; once all are there, merge them with: "
        "autoref report {}\n",
        options.shard.name(), report.done, report.games, folder, folder);
  }
}

// A report that is there holds the games of its time. A complete run writes it again; others say
// what it lacks. Returns the line that says it, if any.
std::string mended_report(const ExperimentReport& report, const ExperimentOptions& options) {
  if (report.done == 0 || !fs::exists(options.folder / kMarkdownReport)) return {};
  const ResultFolder folder = open_results(options.folder, options.build);
  if (!report.is_complete) {
    const std::string shortfall = report_shortfall(folder);
    return shortfall.empty() ? "" : shortfall + "\n";
  }
  const fs::path written = refresh_report(folder);
  return written.empty() ? "" : fmt::format("{}   written again\n", written.string());
}

}  // namespace

int run_verb(const RunArguments& arguments) {
  const Scenario scenario = read_experiment(arguments);
  const ExperimentOptions options = options_of(arguments);
  const ExperimentReport report = run_experiment(scenario, options);
  const std::string about_report = mended_report(report, options);
  if (report.is_interrupted) {
    write_message(
        stderr,
        fmt::format("autoref: interrupted with {} of {} games done; the same command continues\n",
                    report.done, report.games) +
            about_report);
    return kInterrupted;
  }
  if (!arguments.quiet) {
    print_end(scenario, report, options);
    fmt::print("{}", about_report);
  }
  if (!report.is_complete || report.void_games <= kMostVoid * report.games) return kDone;
  write_message(stderr, fmt::format("autoref: {} of {} games are void; {}'s void_reason says why\n",
                                    report.void_games, report.games,
                                    (options.folder / "results.csv").string()));
  return kTooManyVoid;
}

void add_run_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "run", "Run an experiment: all games of a sweep, of teams against each other, of a match.");
  auto arguments = std::make_shared<RunArguments>();
  add_batch_options(*verb, *arguments,
                    "Scenario of kind sweep, roundrobin, gauntlet, sprt or knockout.");
  add_override_options(*verb, *arguments);
  verb->add_option("--shard", arguments->shard,
                   "Play only share I (from 0) of N; other runs play the others.")
      ->type_name("I/N");
  verb->add_flag("--allow-mixed-build", arguments->allow_mixed_build,
                 "Go on in a folder that holds games of another build; those do not count.");
  verb->add_option("--progress", arguments->progress,
                   "Progress on stderr: plain lines, json lines, or none. Default: a table on a "
                   "terminal, else plain.")
      ->type_name("STYLE")
      ->check(CLI::IsMember({"plain", "json", "none"}));
  verb->add_flag("--quiet", arguments->quiet, "Print nothing but errors; the exit code says it.")
      ->excludes("--progress");
  verb->footer(
      "Ctrl-C lets the running games end; a second one stops at once. The same command goes on\n"
      "where the last one stopped; games whose workers were killed are played again. More pairs "
      "go\n"
      "on in the same folder, of fewer the rows beyond do not count; another seed needs another\n"
      "folder. A report that is in the folder is written again when all games are there.\n\n"
      "Shards may share a folder, or each fill one of its own, whose\n"
      "games/*.csv are then copied into one for autoref report. A match ends with the pair of "
      "games\n"
      "that decides it; shards of their own folders play all the pairs that it may have. A shard "
      "of\n"
      "a knockout ends where it waits for others' games; the same command then goes on.\n\n"
      "--progress json: one object a line on stderr, every 5 s and in the end, with event "
      "(progress,\n"
      "end, or note with a text), done, total, void, played (by this run), elapsed_s, "
      "games_per_min,\n"
      "left_s, and by kind standings, groups, sprt or ties, with the columns of the CSVs.\n\n"
      "Example:\n  autoref run scenarios/handicap-speed.yaml -o results/runs/speed -j 2");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return run_verb(*arguments); }; });
}

}  // namespace autoref::runner
