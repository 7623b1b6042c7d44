#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/experiment/batch_arguments.hpp"
#include "app/verbs.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/run/slurm.hpp"
#include "io/command.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::app {
namespace {

struct SubmitArguments : BatchArguments {
  int tasks = 0;                     // 0: the default number
  std::string time;                  // time limit of a task; empty: the partition's limit
  std::string partition;             // empty: the cluster's default
  std::vector<std::string> options;  // options passed on to sbatch
  bool slurm = false;                // required; Slurm is the only engine so far
  bool dry_run = false;
};

namespace fs = std::filesystem;

constexpr int kMostTasks = 10000;  // the maximum number of shards
constexpr int kDefaultTasks = 8;
constexpr int kLeastTime_s = 300;  // minimum per task; games stop in the last minute

// Throws InputError if the path contains a line break, which would break a line of the script.
fs::path plain_path(const std::string& flag, const fs::path& path) {
  if (path.string().find('\n') == std::string::npos) return fs::absolute(path);
  throw io::InputError({flag}, "",
                       "the path contains a line break, which batch scripts do not allow");
}

// Parses "HH:MM:SS"; nullopt for any other text.
std::optional<int> seconds_of(const std::string& text) {
  std::vector<int> parts = {0};
  for (const char c : text) {
    if (c == ':') {
      parts.push_back(0);
    } else if (c < '0' || c > '9' || parts.back() > 9999) {
      return std::nullopt;
    } else {
      parts.back() = 10 * parts.back() + (c - '0');
    }
  }
  if (parts.size() != 3 || parts[1] > 59 || parts[2] > 59) return std::nullopt;
  return 3600 * parts[0] + 60 * parts[1] + parts[2];
}

void check_time(const std::string& time) {
  if (time.empty()) return;
  const std::optional<int> time_s = seconds_of(time);
  if (time_s && *time_s >= kLeastTime_s) return;
  throw io::InputError(
      {"--time"}, "",
      fmt::format("expected HH:MM:SS of at least 00:05:00, such as 01:30:00; found '{}'", time));
}

// Returns the number of tasks: at most one per pair of legs, since a pair is never split between
// tasks.
int tasks_for(int wanted, const experiments::Scenario& scenario, std::size_t games) {
  // Tasks that play in rounds wait for each other after every round.
  const std::optional<std::size_t> round = scenario.experiment().games_of_a_round();
  if (round && wanted == 0) return 1;
  if (round) games = *round;
  const int pairs = static_cast<int>(games / 2);
  if (wanted == 0) return std::min(kDefaultTasks, pairs);
  if (wanted <= pairs) return wanted;
  throw io::InputError(
      {"--tasks"}, "",
      fmt::format("{} games are {} pairs of legs, which cannot be split: use at most {} "
                  "tasks",
                  games, pairs, pairs));
}

experiments::SlurmArray array_of(const SubmitArguments& arguments,
                                 const experiments::Scenario& scenario, std::size_t games) {
  check_time(arguments.time);
  experiments::SlurmArray array;
  // Tasks must run exactly this build, not whatever PATH finds on their machine.
  array.program = plain_path("autoref", fs::read_symlink("/proc/self/exe"));
  array.file = plain_path("the scenario", arguments.file);
  array.folder = plain_path("-o", arguments.results_folder());
  for (const std::string& set : arguments.sets) array.overrides.push_back("--set=" + set);
  if (!arguments.pairs.empty()) array.overrides.push_back("--pairs=" + arguments.pairs);
  if (!arguments.seed.empty()) array.overrides.push_back("--seed=" + arguments.seed);
  array.tasks = tasks_for(arguments.tasks, scenario, games);
  array.waits_for_others = scenario.experiment().games_of_a_round().has_value();
  array.workers = std::max(1, arguments.workers);
  array.time = arguments.time;
  array.partition = arguments.partition;
  array.options = arguments.options;
  return array;
}

// Submits a script with sbatch. Returns the number of the new job.
std::string submit(const std::vector<std::string>& words) {
  const std::optional<io::CommandResult> result = io::run_command(words);
  if (!result) {
    throw io::InputError({}, "",
                         "sbatch is not in PATH: submit from a machine with Slurm, such as a "
                         "cluster's login node, or only write the scripts with --dry-run");
  }
  // With several clusters, sbatch prints "123;name".
  std::string job = result->out.substr(0, result->out.find_first_of(";\n"));
  if (result->code == 0 && !job.empty()) return job;
  throw io::InputOutputError(
      fmt::format("sbatch rejected {} with code {}", words.back(), result->code));
}

void print_commands(const std::string& scripts, const std::string& merging) {
  fmt::print(
      "\nnothing was submitted; to submit:\n  job=$(sbatch --parsable {})\n"
      "  sbatch --dependency=afterany:${{job%;*}} {}\n",
      experiments::shell_word(scripts), experiments::shell_word(merging));
}

int submit_verb(const SubmitArguments& arguments) {
  const experiments::Scenario scenario = read_experiment(arguments);
  const std::size_t games = scenario.experiment().games().size();
  const experiments::SlurmArray array = array_of(arguments, scenario, games);
  const fs::path folder = arguments.results_folder();
  io::create_folder(folder / experiments::kSlurmLogs);
  const std::string tasks = (folder / "submit.sbatch").string();
  const std::string merging = (folder / "merge.sbatch").string();
  io::replace_file(tasks, experiments::array_script(array));
  io::replace_file(merging, experiments::merge_script(array));
  fmt::print("{}   {} games in {} tasks, {} in parallel each\n{}   merges their rows\n", tasks,
             games, array.tasks, array.workers, merging);
  if (arguments.dry_run) {
    print_commands(tasks, merging);
    return io::kDone;
  }
  const std::string job = submit({"sbatch", "--parsable", tasks});
  fmt::print("\nsubmitted as job {}\n", job);
  const std::string merge =
      submit({"sbatch", "--parsable", fmt::format("--dependency=afterany:{}", job), merging});
  fmt::print("job {} writes the results after all tasks have ended\n\n", merge);
  fmt::print("squeue -j {},{}   state of the jobs; the tasks log to {}\n", job, merge,
             (folder / experiments::kSlurmLogs).string());
  fmt::print("autoref results status {}   progress of the games\n",
             experiments::shell_word(folder.string()));
  return io::kDone;
}

}  // namespace

void add_submit_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("submit", "Run an experiment on a cluster, as a Slurm job array.");
  auto arguments = std::make_shared<SubmitArguments>();
  add_experiment_argument(*verb, *arguments, "run");
  add_batch_options(*verb, *arguments);
  add_override_options(*verb, *arguments);
  verb->get_option("--workers")->description("Games played in parallel in each task. Default: 1.");
  verb->add_flag("--slurm", arguments->slurm, "Use Slurm (required; the only supported scheduler).")
      ->required();
  verb->add_option(
          "--tasks", arguments->tasks,
          fmt::format("Tasks that share the games. Default: {}; 1 for kind tune.", kDefaultTasks))
      ->type_name("N")
      ->check(CLI::Range(1, kMostTasks));
  verb->add_option("--time", arguments->time,
                   "Time limit of a task; a task that needs longer requeues itself and continues.")
      ->type_name("HH:MM:SS");
  verb->add_option("--partition", arguments->partition,
                   "Partition to run in. Default: the cluster's.")
      ->type_name("P");
  verb->add_option(
          "--sbatch", arguments->options,
          "Option passed on to sbatch, such as --sbatch=--account=vision. May be repeated.")
      ->type_name("OPTION")
      ->allow_extra_args(false);
  verb->add_flag("--dry-run", arguments->dry_run, "Write the scripts without submitting them.");
  verb->footer(
      "The results folder must be on a disk shared by all machines. Submitting again plays the\n"
      "missing games.\n\n"
      "Example:\n  autoref experiment submit scenarios/handicap-speed.yaml --slurm --tasks 20 "
      "--time "
      "01:00:00");
  choose(*verb, chosen, arguments, submit_verb);
}

}  // namespace autoref::app
