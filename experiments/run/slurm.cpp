#include "experiments/run/slurm.hpp"

#include <fmt/format.h>

namespace autoref::experiments {
namespace {

std::string option(const std::string& text) { return fmt::format("#SBATCH {}\n", text); }

// The option for a job's output file. Slurm replaces patterns such as %j in `name`.
std::string output_option(const SlurmArray& array, const std::string& name) {
  std::string path;
  for (const char c : (array.folder / kSlurmLogs).string())
    path += c == '%' ? "%%" : std::string(1, c);
  return option(shell_word(fmt::format("--output={}/{}", path, name)));
}

// The options of both jobs.
std::string common_options(const SlurmArray& array) {
  std::string text = option("--open-mode=append");
  if (!array.partition.empty()) {
    text += option(shell_word("--partition=" + array.partition));
  }
  for (const std::string& further : array.options) text += option(shell_word(further));
  return text;
}

std::string words_of(const std::vector<std::string>& overrides) {
  std::string text;
  for (const std::string& option : overrides) text += " " + shell_word(option);
  return text;
}

// The conditions for a task to requeue itself. A run that waited too long ends with code 75 without
// a signal.
constexpr const char* kTime = "$ending == time";
constexpr const char* kTimeOrWaitedInVain = "$ending == time || (-z $ending && $code == 75)";

// A trapped signal interrupts `wait`, so a second `wait` lets the run finish its games. A process
// is restarted after 1, 4, 9 ... s if it was killed or if its rows are still locked by a process
// killed on another node. The total exceeds the 90 s for which NFS keeps a dead node's locks.
constexpr const char* kTask = R"(
set -u
run=
ending=
end() {{ ending=$1; kill -TERM "$run" 2>/dev/null; }}
trap 'end time' USR1   # the time limit is near
trap 'end asked' TERM  # cancelled, or pre-empted

code=75
for try in 1 2 3 4 5 6; do
  [[ -z $ending ]] || break
  {program} run {file} -o {folder} --shard "$SLURM_ARRAY_TASK_ID/{tasks}" -j {workers}{overrides} &
  run=$!
  wait "$run"; code=$?
  [[ -z $ending ]] || {{ wait "$run"; code=$?; }}
  ((code == 74 || code > 128)) || break
  sleep $((try * try))
done

if [[ {requeue_if} ]] && ((code != 0 && ${{SLURM_RESTART_COUNT:-0}} < 100)); then
  scontrol requeue "$SLURM_JOB_ID"
fi
exit "$code"
)";

}  // namespace

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string plain_shell_word(const std::string& text) {
  constexpr const char* kSpecial = " \t\n\"'\\$`&;|<>()*?[]#!~{}";  // special in a shell
  const bool is_plain = !text.empty() && text.find_first_of(kSpecial) == std::string::npos;
  return is_plain ? text : shell_word(text);
}

std::string array_script(const SlurmArray& array) {
  const std::string name = array.file.stem().string();
  std::string text =
      "#!/bin/bash\n"
      "# Plays an experiment as a Slurm job array; each task plays its share of the games. "
      "Written\n"
      "# by autoref experiment submit. Submit it again to play the missing games.\n";
  text += option(shell_word("--job-name=" + name));
  text += option(fmt::format("--array=0-{}", array.tasks - 1));
  text += option(fmt::format("--cpus-per-task={}", array.workers));
  text += output_option(array, "%A_%a.log");
  text += option("--requeue");
  text += option("--signal=B:USR1@60");
  if (!array.time.empty()) text += option(fmt::format("--time={}", array.time));
  text += common_options(array);
  return text +
         fmt::format(kTask, fmt::arg("program", shell_word(array.program.string())),
                     fmt::arg("file", shell_word(array.file.string())),
                     fmt::arg("folder", shell_word(array.folder.string())),
                     fmt::arg("tasks", array.tasks), fmt::arg("workers", array.workers),
                     fmt::arg("overrides", words_of(array.overrides)),
                     fmt::arg("requeue_if", array.waits_for_others ? kTimeOrWaitedInVain : kTime));
}

std::string merge_script(const SlurmArray& array) {
  const std::string name = array.file.stem().string() + "-merge";
  std::string text =
      "#!/bin/bash\n"
      "# Merges the rows of an experiment's tasks and writes its results. Written by autoref "
      "experiment submit.\n";
  text += option(shell_word("--job-name=" + name));
  text += output_option(array, "%j-merge.log");
  text += common_options(array);
  return text + fmt::format("\nexec {} report {}\n", shell_word(array.program.string()),
                            shell_word(array.folder.string()));
}

}  // namespace autoref::experiments
