// Batch scripts for Slurm, the engine of clusters: an experiment as an array of tasks, a shard
// each, and the job that merges their rows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace autoref::runner {

struct SlurmArray {
  // Absolute paths, on a disk that all machines of the cluster share.
  std::filesystem::path program;       // autoref
  std::filesystem::path file;          // the experiment
  std::filesystem::path folder;        // of the results
  std::vector<std::string> overrides;  // further options of autoref run, such as "--seed=7"
  int tasks = 8;
  int workers = 1;                   // processors of each task
  std::string time;                  // HH:MM:SS for each task; empty: the partition's limit
  std::string partition;             // empty: the cluster's default
  std::vector<std::string> options;  // further ones of sbatch, such as "--account=vision"
};

// Where the scripts' output goes, below the folder of results. Slurm does not create it.
inline constexpr const char* kSlurmLogs = "slurm";

// The script of the array. A task that is killed, pre-empted, or about to meet its time limit goes
// on where it stopped: its process is started again, or the task goes back to the queue.
std::string array_script(const SlurmArray& array);

// The script of the job that writes the results of whatever rows are there.
std::string merge_script(const SlurmArray& array);

// Text as one word of a shell, and of a line of #SBATCH.
std::string shell_word(const std::string& text);

}  // namespace autoref::runner
