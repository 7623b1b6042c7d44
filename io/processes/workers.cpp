#include "io/processes/workers.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sched.h>

#include <algorithm>
#include <deque>
#include <optional>

#include "io/errors.hpp"
#include "io/processes/worker_process.hpp"

namespace autoref::io {
namespace {

constexpr int kTick_ms = 250;

class Pool {
 public:
  Pool(const std::vector<std::size_t>& jobs, const WorkerOptions& options, const WorkerCalls& calls)
      : options_(options),
        calls_(calls),
        workers_(std::min(static_cast<std::size_t>(std::max(1, options.workers)), jobs.size())) {
    for (const std::size_t job : jobs) queue_.push_back({job, 1});
  }

  Ending run() {
    while (true) {
      if (goes_on() && !is_enough()) hand_out();
      const auto running =
          std::count_if(workers_.begin(), workers_.end(),
                        [](const WorkerProcess& worker) { return worker.is_busy(); });
      if (running == 0 && !failure_.empty()) throw EnvironmentError(failure_);
      if (running == 0) return signals_.count() == 0 ? Ending::kDone : Ending::kInterrupted;
      wait();
      // The first signal lets running jobs finish; the second abandons them. Their workers are
      // killed with the pool.
      if (signals_.count() > 1) return Ending::kInterrupted;
      if (signals_.count() == 1) announce_ending(static_cast<int>(running));
      for (WorkerProcess& worker : workers_) check_time(worker);
      if (calls_.tick) calls_.tick();
    }
  }

 private:
  bool goes_on() { return signals_.count() == 0 && failure_.empty(); }

  bool is_enough() const { return calls_.is_enough && calls_.is_enough(); }

  void announce_ending(int running) {
    if (calls_.ending && !is_ending_) calls_.ending(running);
    is_ending_ = true;
  }

  void hand_out() {
    for (WorkerProcess& worker : workers_) {
      if (worker.is_busy() || queue_.empty()) continue;
      if (calls_.starting) calls_.starting(queue_.front().number);
      try {
        worker.start(signals_, calls_.work);
      } catch (const InputOutputError& error) {
        failure_ = error.what();
        return;
      }
      worker.give(queue_.front());
      queue_.pop_front();
    }
  }

  // Waits for an answer or a signal, but at most one tick, so that time limits are checked
  // regularly.
  void wait() {
    std::vector<pollfd> watched = {{signals_.descriptor(), POLLIN, 0}};
    std::vector<WorkerProcess*> busy;
    for (WorkerProcess& worker : workers_) {
      if (!worker.is_busy()) continue;
      watched.push_back({worker.socket(), POLLIN, 0});
      busy.push_back(&worker);
    }
    if (poll(watched.data(), watched.size(), kTick_ms) <= 0) return;
    for (std::size_t i = 0; i < busy.size(); ++i) {
      if (watched[i + 1].revents != 0) receive(*busy[i]);
    }
  }

  void receive(WorkerProcess& worker) {
    const Job job = worker.job();
    const double wall_s = worker.busy_s();
    std::optional<WorkerAnswer> answer = worker.answer();
    if (!answer) return lose(job, worker.end(), wall_s);
    worker.be_free();
    if (!answer->failure.empty()) {
      failure_ = answer->failure;
      return;
    }
    // The worker continues to play while the result is written to disk.
    if (!calls_.is_enough && goes_on()) hand_out();
    calls_.done({job.number, std::move(answer->payload), "", job.attempt, wall_s});
  }

  void check_time(WorkerProcess& worker) {
    if (!worker.is_busy() || worker.busy_s() < options_.longest_job_s) return;
    const Job job = worker.job();
    const double wall_s = worker.busy_s();
    worker.end();
    // A job that hangs once will hang again, so a retry would only waste the same time again.
    give_up(job, fmt::format("it took longer than {} s", options_.longest_job_s), wall_s, true);
  }

  void lose(const Job& job, const std::string& reason, double wall_s) {
    if (job.attempt < options_.attempts) {
      // Retry immediately, so that jobs keep their order as far as possible.
      queue_.push_front({job.number, job.attempt + 1});
    } else {
      give_up(job, reason, wall_s);
    }
  }

  void give_up(const Job& job, const std::string& reason, double wall_s, bool is_late = false) {
    const std::string failure = fmt::format("{}, in attempt {}", reason, job.attempt);
    calls_.done({job.number, "", failure, job.attempt, wall_s, is_late});
  }

  const WorkerOptions& options_;
  const WorkerCalls& calls_;
  EndSignals signals_;
  std::deque<Job> queue_;
  std::vector<WorkerProcess> workers_;
  bool is_ending_ = false;
  std::string failure_;  // failure of the machine during a job; no more jobs are started after it
};

}  // namespace

int processors() {
  // Unlike the machine's number of processors, the affinity mask respects taskset and the
  // processors that a batch system has allotted.
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

Ending do_jobs(const std::vector<std::size_t>& jobs, const WorkerOptions& options,
               const WorkerCalls& calls) {
  return Pool(jobs, options, calls).run();
}

}  // namespace autoref::io
