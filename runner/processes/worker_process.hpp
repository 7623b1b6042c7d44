// One worker process, and the signals that ask a run to end. For workers.cpp.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <optional>
#include <string>

namespace autoref::runner {

// Holds back SIGINT, SIGTERM and SIGHUP while it lives, and counts them.
class EndSignals {
 public:
  EndSignals();
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  int descriptor() const { return descriptor_; }           // readable when one has come
  const sigset_t& former_mask() const { return former_; }  // of signals, for workers

  // How many have come so far.
  int count();

 private:
  sigset_t former_{};
  int descriptor_ = -1;
  int count_ = 0;
};

struct Job {
  std::size_t number = 0;
  int attempt = 1;
};

// One process, or the place for one. It is killed with this object.
class WorkerProcess {
 public:
  using Work = std::function<std::string(std::size_t job)>;

  WorkerProcess() = default;
  ~WorkerProcess() { end(); }
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  bool is_busy() const { return job_.has_value(); }
  const Job& job() const { return *job_; }
  int socket() const { return socket_; }  // readable when an answer is there, or none will come
  double busy_s() const;

  // Starts the process where there is none. Throws InputOutputError.
  void start(const EndSignals& signals, const Work& work);

  // Sending to a dead worker fails silently: its end is noticed when its answer is read.
  void give(const Job& job);

  // The answer to the job; none where the worker is dead.
  std::optional<std::string> answer();

  void be_free() { job_.reset(); }

  // Says how the process ended; one that is still there is killed.
  std::string end();

 private:
  pid_t pid_ = -1;
  int socket_ = -1;
  std::optional<Job> job_;
  std::chrono::steady_clock::time_point began_;
};

}  // namespace autoref::runner
