#include "live/prompt_thread.hpp"

#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace autoref::live {
namespace {

constexpr std::uint64_t kTurn_ns = 100'000;  // the shortest that Linux grants

// The kernel's struct sched_attr, whose header contradicts <sched.h>.
struct SchedulingAttributes {
  std::uint32_t size;
  std::uint32_t policy;
  std::uint64_t flags;
  std::int32_t nice;
  std::uint32_t priority;
  std::uint64_t runtime_ns;  // with the ordinary policy: the length of a turn
  std::uint64_t deadline_ns;
  std::uint64_t period_ns;
};

}  // namespace

void be_prompt() {
  prctl(PR_SET_TIMERSLACK, 1, 0, 0, 0);
  SchedulingAttributes attributes{};
  if (syscall(SYS_sched_getattr, 0, &attributes, sizeof attributes, 0) != 0) return;
  if (attributes.policy != SCHED_OTHER) return;
  attributes.runtime_ns = kTurn_ns;
  syscall(SYS_sched_setattr, 0, &attributes, 0);
}

}  // namespace autoref::live
