#include "live/frame_pacer.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <thread>

namespace autoref::live {
namespace {

TEST(PromptThread, KeepsItsPolicyAndPriority) {
  std::thread([] {
    setpriority(PRIO_PROCESS, 0, 3);
    be_prompt();
    EXPECT_EQ(getpriority(PRIO_PROCESS, 0), 3);
    EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
  }).join();
}

TEST(PromptThread, ItsTimersAreNotDelayed) {
  std::thread([] {
    be_prompt();
    EXPECT_EQ(prctl(PR_GET_TIMERSLACK, 0, 0, 0, 0), 1);
  }).join();
}

}  // namespace
}  // namespace autoref::live
