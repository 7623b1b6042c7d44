// Work in processes of their own: jobs go out and results come back over sockets.
//
// Each worker is a fork of this process and does one job after the other; a worker that dies takes
// one job along, which is done again; a job that takes too long is given up. Workers never outlive
// this process. The parent stays single-threaded and is the only one to see results.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::runner {

struct WorkerOptions {
  int workers = 1;
  int attempts = 3;            // until a job whose workers die is given up
  double longest_job_s = 600;  // after which a job is taken to hang and given up at once
};

struct JobResult {
  std::size_t job = 0;
  std::string payload;   // what the work returned; never empty, at most 100 kB
  std::string failure;   // why the job was given up; empty where it was done
  int attempt = 1;       // counted from 1
  double wall_s = 0;     // of this attempt
  bool is_late = false;  // given up because it took too long
};

struct WorkerCalls {
  std::function<std::string(std::size_t job)> work;   // in a worker
  std::function<void(const JobResult& result)> done;  // here, as results come in; may throw
  std::function<void()> tick;                         // here, about four times a second
  std::function<bool()> is_enough = {};               // here: whether no further job is to begin
  std::function<void(int running)> ending = {};       // here, once, after the first signal
};

// Whether a failure says that the worker was ended from outside, by the out-of-memory killer, say,
// or by a user: the job itself may be well. A crash or a job that takes too long is the job's own.
bool was_killed(std::string_view failure);

enum class Ending { kDone, kInterrupted };

// The processors that this process may use.
int processors();

// Does `jobs`, in their order as far as workers are free. On SIGINT, SIGTERM or SIGHUP no further
// job is begun; on a second one the workers are killed at once. Returns kInterrupted after a
// signal, whether or not jobs are left. Throws what `done` throws, and InputOutputError where no
// process can be started.
Ending do_jobs(const std::vector<std::size_t>& jobs, const WorkerOptions& options,
               const WorkerCalls& calls);

}  // namespace autoref::runner
