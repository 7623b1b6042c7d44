#include "io/processes/workers.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>

#include "tests/support/temporary_folder.hpp"

namespace autoref::io {
namespace {

struct Outcome {
  Ending ending = Ending::kDone;
  std::map<std::size_t, JobResult> results;
};

Outcome done_by(int workers, std::size_t jobs, const std::function<std::string(const Job&)>& work,
                WorkerOptions options = {}) {
  options.workers = workers;
  std::vector<std::size_t> numbers(jobs);
  for (std::size_t i = 0; i < jobs; ++i) numbers[i] = i;
  Outcome outcome;
  outcome.ending = do_jobs(numbers, options,
                           {work, [&](const JobResult& r) { outcome.results[r.job] = r; }, {}});
  return outcome;
}

TEST(Workers, DoEveryJobOnce) {
  for (const int workers : {1, 2, 5}) {
    const Outcome outcome = done_by(
        workers, 40, [](const Job& job) { return std::to_string(job.number * job.number); });
    EXPECT_EQ(outcome.ending, Ending::kDone);
    ASSERT_EQ(outcome.results.size(), 40U);
    for (const auto& [job, result] : outcome.results) {
      EXPECT_EQ(result.payload, std::to_string(job * job));
    }
  }
}

TEST(Workers, AreSeparateProcessesThatDoSeveralJobs) {
  const Outcome outcome = done_by(2, 20, [](const Job&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return std::to_string(getpid());
  });
  std::set<std::string> pids;
  for (const auto& [job, result] : outcome.results) pids.insert(result.payload);
  EXPECT_EQ(pids.size(), 2U);
  EXPECT_FALSE(pids.contains(std::to_string(getpid())));
}

TEST(Workers, RetryTheJobOfAKilledWorker) {
  const TemporaryFolder folder;
  const Outcome outcome = done_by(2, 6, [&](const Job& job) {
    const std::filesystem::path mark = folder / "killed";
    if (job.number == 3 && !std::filesystem::exists(mark)) {
      write_content(mark, "x");
      kill(getpid(), SIGKILL);
    }
    return fmt::format("attempt {}", job.attempt);
  });
  ASSERT_EQ(outcome.results.size(), 6U);
  EXPECT_EQ(outcome.results.at(3).payload, "attempt 2");
  EXPECT_EQ(outcome.results.at(4).payload, "attempt 1");
  EXPECT_EQ(outcome.results.at(3).attempt, 2);
  EXPECT_EQ(outcome.results.at(4).attempt, 1);
}

TEST(Workers, GiveUpAJobAfterThreeDeathsAndSayWhy) {
  const Outcome outcome = done_by(1, 3, [](const Job& job) {
    if (job.number == 1) kill(getpid(), SIGKILL);
    return std::string("fine");
  });
  EXPECT_EQ(outcome.ending, Ending::kDone);
  EXPECT_EQ(outcome.results.at(1).failure,
            "its process was ended by signal 9 (Killed), in attempt 3");
  EXPECT_EQ(outcome.results.at(2).payload, "fine");
}

TEST(Workers, DistinguishAKillFromACrash) {
  EXPECT_TRUE(was_killed("its process was ended by signal 9 (Killed), in attempt 3"));
  EXPECT_TRUE(was_killed("its process was ended by signal 15 (Terminated), in attempt 3"));
  EXPECT_FALSE(was_killed("its process was ended by signal 11 (Segmentation fault), in attempt 3"));
  EXPECT_FALSE(was_killed("its process was ended by signal 6 (Aborted), in attempt 3"));
  EXPECT_FALSE(was_killed("it took longer than 600 s, in attempt 1"));
  EXPECT_FALSE(was_killed("the game threw: its process was ended by signal 9"));
  EXPECT_FALSE(was_killed(""));
}

TEST(Workers, GiveUpAJobThatTakesTooLongAtItsFirstAttempt) {
  WorkerOptions options;
  options.attempts = 3;
  options.longest_job_s = 3;  // far more than the other job needs, even on a busy machine
  const Outcome outcome = done_by(
      1, 2,
      [](const Job& job) {
        if (job.number == 0) std::this_thread::sleep_for(std::chrono::hours(1));
        return std::string("fine");
      },
      options);
  EXPECT_EQ(outcome.results.at(0).failure, "it took longer than 3 s, in attempt 1");
  EXPECT_EQ(outcome.results.at(1).payload, "fine");
}

TEST(Workers, FinishRunningJobsAfterTheFirstInterrupt) {
  int results = 0;
  const Ending ending = do_jobs({0, 1, 2, 3, 4, 5, 6, 7}, {.workers = 2},
                                {[](const Job&) {
                                   std::this_thread::sleep_for(std::chrono::milliseconds(20));
                                   return std::string("fine");
                                 },
                                 [&](const JobResult& result) {
                                   EXPECT_EQ(result.failure, "");
                                   if (++results == 1) kill(getpid(), SIGINT);
                                 },
                                 {}});
  EXPECT_EQ(ending, Ending::kInterrupted);
  EXPECT_GE(results, 2);
  EXPECT_LE(results, 4);
}

TEST(Workers, AnnounceTheEndOnceAfterAnInterrupt) {
  int announced = 0;
  do_jobs({0, 1, 2, 3}, {.workers = 2},
          {[](const Job& job) {
             if (job.number == 0) kill(getppid(), SIGINT);
             std::this_thread::sleep_for(std::chrono::milliseconds(600));
             return std::string("fine");
           },
           [](const JobResult&) {},
           {},
           {},
           [&announced](int running) {
             ++announced;
             EXPECT_EQ(running, 2);
           }});
  EXPECT_EQ(announced, 1);
}

TEST(Workers, StartNoMoreJobsOnceItIsEnough) {
  int results = 0;
  const Ending ending = do_jobs({0, 1, 2, 3, 4, 5, 6, 7}, {.workers = 2},
                                {[](const Job&) { return std::string("fine"); },
                                 [&](const JobResult&) { ++results; },
                                 {},
                                 [&] { return results >= 3; }});
  EXPECT_EQ(ending, Ending::kDone);
  EXPECT_GE(results, 3);
  EXPECT_LE(results, 4);
}

// Whether the second of two jobs of one worker has begun while the first one's result is handled.
bool has_second_job_begun(const std::function<bool()>& is_enough, int patience_ms) {
  const TemporaryFolder folder;
  const std::filesystem::path mark = folder / "begun";
  bool has_begun = false;
  do_jobs({0, 1}, {.workers = 1},
          {[&](const Job& job) {
             if (job.number == 1) write_content(mark, "yes");
             return std::string("fine");
           },
           [&](const JobResult& result) {
             if (result.job != 0) return;
             for (int ms = 0; ms < patience_ms && !std::filesystem::exists(mark); ++ms)
               std::this_thread::sleep_for(std::chrono::milliseconds(1));
             has_begun = std::filesystem::exists(mark);
           },
           {},
           is_enough});
  return has_begun;
}

TEST(Workers, PlayOnWhileTheirLastResultIsHandled) { EXPECT_TRUE(has_second_job_begun({}, 60000)); }

TEST(Workers, WaitForTheirLastResultIfItMayBeEnough) {
  EXPECT_FALSE(has_second_job_begun([] { return false; }, 100));
}

TEST(Workers, StopAtOnceAfterTheSecondInterrupt) {
  int ticks = 0;
  const Ending ending = do_jobs({0, 1}, {.workers = 2},
                                {[](const Job&) {
                                   std::this_thread::sleep_for(std::chrono::seconds(60));
                                   return std::string("fine");
                                 },
                                 [](const JobResult&) { FAIL() << "waited for a job"; },
                                 [&] {
                                   if (++ticks <= 2) kill(getpid(), SIGTERM);
                                 }});
  EXPECT_EQ(ending, Ending::kInterrupted);
}

TEST(Workers, AreKilledWhenTheReceiverThrows) {
  EXPECT_THROW(do_jobs({0, 1, 2}, {.workers = 2},
                       {[](const Job&) { return std::string("fine"); },
                        [](const JobResult&) { throw std::runtime_error("disk full"); },
                        {}}),
               std::runtime_error);
}

}  // namespace
}  // namespace autoref::io
