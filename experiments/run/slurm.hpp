// Batch scripts for Slurm, the cluster workload manager: a job array with one task per shard of an
// experiment, and the job that merges their rows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace autoref::experiments {

struct SlurmArray {
  // Absolute paths on a file system shared by all nodes of the cluster.
  std::filesystem::path program;       // autoref
  std::filesystem::path file;          // the experiment's scenario file
  std::filesystem::path folder;        // the results folder
  std::vector<std::string> overrides;  // additional options of autoref run, such as "--seed=7"
  // Whether tasks depend on each other's games. If they do, a task that has waited too long
  // requeues itself.
  bool waits_for_others = false;
  int tasks = 8;
  int workers = 1;  // number of processors per task
  // Time limit per task, as HH:MM:SS; if empty, the partition's limit.
  std::string time;
  std::string partition;             // if empty, the cluster's default
  std::vector<std::string> options;  // additional sbatch options, such as "--account=vision"
};

// Name of the subfolder of the results folder for the output of the jobs. Slurm does not create it.
inline constexpr const char* kSlurmLogs = "slurm";

// The batch script of the job array. A task that is killed, pre-empted or about to reach its time
// limit resumes where it stopped: either its process is restarted or the task is requeued.
std::string array_script(const SlurmArray& array);

// The script of the job that writes the results from all rows that exist when it runs.
std::string merge_script(const SlurmArray& array);

// Quotes text as a single word for the shell and for #SBATCH lines.
std::string shell_word(const std::string& text);

// The same for the shell only, and without quotes if the word needs none.
std::string plain_shell_word(const std::string& text);

}  // namespace autoref::experiments
