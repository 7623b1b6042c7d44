// One worker process, and the signals that ask a run to end. Used by workers.cpp.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <optional>
#include <string>

#include "io/processes/workers.hpp"

namespace autoref::io {

// Blocks SIGINT, SIGTERM and SIGHUP during its lifetime and counts them.
class EndSignals {
 public:
  EndSignals();
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  int descriptor() const { return descriptor_; }           // readable when a signal has arrived
  const sigset_t& former_mask() const { return former_; }  // signal mask to restore in workers

  // Number of signals so far.
  int count();

 private:
  sigset_t former_{};
  int descriptor_ = -1;
  int count_ = 0;
};

struct WorkerAnswer {
  std::string payload;
  std::string failure;  // failure of the environment; empty if the job was done
};

// A worker process, or an empty slot for one. Destroying the object kills the process.
class WorkerProcess {
 public:
  using Work = std::function<std::string(const Job& job)>;

  WorkerProcess() = default;
  ~WorkerProcess() { end(); }
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  bool is_busy() const { return job_.has_value(); }
  const Job& job() const { return *job_; }
  int socket() const {
    return socket_;
  }  // readable when an answer has arrived or the worker has died
  double busy_s() const;

  // Starts the process unless it is running. Throws InputOutputError.
  void start(const EndSignals& signals, const Work& work);

  // Sends a job. Fails silently if the worker is dead, which is noticed when its answer is read.
  void give(const Job& job);

  // Returns the worker's answer to the job, or nullopt if the worker is dead.
  std::optional<WorkerAnswer> answer();

  void be_free() { job_.reset(); }

  // Ends the process, killing it if necessary, and says how it ended.
  std::string end();

 private:
  pid_t pid_ = -1;
  int socket_ = -1;
  std::optional<Job> job_;
  std::chrono::steady_clock::time_point began_;
};

}  // namespace autoref::io
