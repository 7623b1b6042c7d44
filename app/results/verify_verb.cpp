#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>

#include "app/results/folder_arguments.hpp"
#include "app/results/judged_results.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/run/program_versions.hpp"
#include "experiments/run/verification.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"
#include "judge/judged_rows.hpp"

namespace autoref::app {
namespace {

struct VerifyArguments : FolderArguments {
  int sample = 5;
  int workers = 0;  // 0: one per processor
};

int verify_verb(const VerifyArguments& arguments) {
  const experiments::ResultFolder folder =
      experiments::open_results(arguments.folder, arguments.build);
  if (folder.build != io::build_id()) {
    fmt::print("the games were played by build {}; this is build {}\n", folder.build,
               io::build_id());
  }
  const int workers = worker_count(arguments.workers);
  const auto play_again = [&folder](const game::GameConfiguration& game,
                                    experiments::GameRow& row) {
    if (!is_judged(folder.scenario)) {
      row.record = experiments::play_recorded(game, folder.path);
      return;
    }
    game::GamePrograms programs = experiments::recorded_programs(game, folder.path);
    judge::play_judged(game, programs, row);
    programs.finish(row.record);
  };
  const experiments::Verification verification =
      experiments::verify(folder, arguments.sample, workers, play_again, stderr);
  for (const experiments::Difference& difference : verification.differences) {
    const auto& [column, stored, now] = difference.column;
    fmt::print("{}: {} was {}, is now {}\n", difference.id, column, stored, now);
  }
  const auto different = static_cast<int>(verification.differences.size());
  fmt::print("{} of {} games match their rows\n", verification.played - different,
             verification.played);
  const std::set<std::string> faults = folder.faults();
  for (const std::string& fault : faults) fmt::print("{}\n", fault);
  return different == 0 && faults.empty() ? io::kDone : io::kDifferent;
}

}  // namespace

void add_verify_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "verify", "Replay some games of a folder and compare them with their stored rows.");
  auto arguments = std::make_shared<VerifyArguments>();
  add_folder_options(*verb, *arguments);
  verb->add_option("--sample", arguments->sample,
                   "Number of games to replay, spread evenly over the folder. Default: 5.")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
  add_workers_option(*verb, arguments->workers);
  verb->footer("Example:\n  autoref results verify results/runs/first-look --sample 5");
  choose(*verb, chosen, arguments, verify_verb);
}

}  // namespace autoref::app
