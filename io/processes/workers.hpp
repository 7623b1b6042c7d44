// A pool of worker processes: jobs go out and results come back over sockets.
//
// Each worker is a fork of this process and does one job at a time. If a worker dies, its job is
// retried; a job that takes too long is abandoned. Workers never outlive this process. The parent
// stays single-threaded, and only it receives results.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/errors.hpp"

namespace autoref::io {

struct WorkerOptions {
  int workers = 1;
  int attempts = 3;            // attempts at a job if its workers die
  double longest_job_s = 600;  // a longer job is assumed to hang and is given up
};

struct Job {
  std::size_t number = 0;
  int attempt = 1;  // number of the attempt, from 1
};

struct JobResult {
  std::size_t job = 0;
  std::string payload;   // return value of the work; never empty, at most 100 kB
  std::string failure;   // why the job was given up; empty if it succeeded
  int attempt = 1;       // number of the attempt, from 1
  double wall_s = 0;     // duration of this attempt
  bool is_late = false;  // given up because it took too long
};

struct WorkerCalls {
  std::function<std::string(const Job& job)> work;    // runs in a worker
  std::function<void(const JobResult& result)> done;  // runs here for each result; may throw
  std::function<void()> tick;                         // runs here, about four times a second
  // Runs here; if it returns true, no new jobs are started. Without this function, results never
  // stop jobs, so a worker gets its next job before `done` runs for its last one.
  std::function<bool()> is_enough = {};
  std::function<void(int running)> ending = {};        // runs here once, after the first signal
  std::function<void(std::size_t job)> starting = {};  // runs here before each attempt
};

// Returns whether a failure means that the worker was killed from outside, for example by the
// out-of-memory killer or by a user; the job itself may then be fine. A crash or a timeout is the
// job's own fault.
bool was_killed(std::string_view failure);

enum class Ending { kDone, kInterrupted };

// Number of processors available to this process.
int processors();

// The environment has failed: a job threw an exception that environment_failure() recognises, or no
// process can be started for a job. Thrown once the running jobs have ended.
class EnvironmentError : public InputOutputError {
 public:
  using InputOutputError::InputOutputError;
};

// Runs `jobs` in order, as workers become free. After SIGINT, SIGTERM or SIGHUP no more jobs are
// started; a second signal kills the workers immediately. Returns kInterrupted after a signal,
// whether or not jobs are left. Throws whatever `done` throws, and EnvironmentError if no process
// can be started or `work` reports a failure of the environment; the job then has no result.
Ending do_jobs(const std::vector<std::size_t>& jobs, const WorkerOptions& options,
               const WorkerCalls& calls);

}  // namespace autoref::io
