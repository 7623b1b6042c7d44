#include "benchmarks/worker_costs.hpp"

#include <sys/mman.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <ctime>
#include <new>
#include <optional>
#include <string>
#include <string_view>

#include "game/loop/game.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::benchmarks {

struct WorkerMeter::Totals {
  std::atomic<std::int64_t> games = 0;
  std::atomic<std::int64_t> frames = 0;
  std::atomic<std::int64_t> set_up_ns = 0;
  std::atomic<std::int64_t> frames_ns = 0;
  std::atomic<std::int64_t> private_kb = 0;
  std::atomic<std::int64_t> resident_kb = 0;
};

namespace {

static_assert(std::atomic<std::int64_t>::is_always_lock_free, "needed between processes");

std::int64_t processor_ns() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1'000'000'000 * static_cast<std::int64_t>(time.tv_sec) + time.tv_nsec;
}

void raise_to(std::atomic<std::int64_t>& most, std::int64_t value) {
  std::int64_t before = most;
  while (before < value && !most.compare_exchange_weak(before, value)) {
  }
}

// A value from /proc/self/smaps_rollup, in kB of 1024 bytes; 0 if it is missing.
std::int64_t kb_in(std::string_view text, std::string_view name) {
  std::size_t at = text.find(name);
  if (at == std::string_view::npos) return 0;
  at = text.find_first_not_of(' ', at + name.size());
  std::int64_t kb = 0;
  if (at != std::string_view::npos)
    std::from_chars(text.data() + at, text.data() + text.size(), kb);
  return kb;
}

double megabytes(std::int64_t kb) { return 1024e-6 * static_cast<double>(kb); }

}  // namespace

WorkerMeter::WorkerMeter() {
  void* memory =
      mmap(nullptr, sizeof(Totals), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw io::io_error("cannot create shared memory", errno);
  totals_ = new (memory) Totals;
}

WorkerMeter::~WorkerMeter() { munmap(totals_, sizeof(Totals)); }

game::GameRecord WorkerMeter::play(const game::GameConfiguration& configuration,
                                   bool with_memory) const {
  const std::int64_t begin_ns = processor_ns();
  std::optional<game::Game> game(configuration);
  const std::int64_t first_frame_ns = processor_ns();
  while (game->step()) {
  }
  const std::int64_t last_frame_ns = processor_ns();
  game::GameRecord record = game->record();
  if (with_memory) {
    const std::string memory = io::read_file("/proc/self/smaps_rollup").value_or("");
    raise_to(totals_->private_kb,
             kb_in(memory, "\nPrivate_Clean:") + kb_in(memory, "\nPrivate_Dirty:"));
    raise_to(totals_->resident_kb, kb_in(memory, "\nRss:"));
  }
  game.reset();
  ++totals_->games;
  totals_->frames += record.frames;
  totals_->frames_ns += last_frame_ns - first_frame_ns;
  totals_->set_up_ns += first_frame_ns - begin_ns + processor_ns() - last_frame_ns;
  return record;
}

WorkerCosts WorkerMeter::costs() const {
  return {totals_->games,
          totals_->frames,
          1e-9 * static_cast<double>(totals_->set_up_ns),
          1e-9 * static_cast<double>(totals_->frames_ns),
          megabytes(totals_->private_kb),
          megabytes(totals_->resident_kb)};
}

}  // namespace autoref::benchmarks
