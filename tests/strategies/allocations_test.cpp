#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "strategies/registry.hpp"
#include "tests/strategies/staged_world.hpp"

namespace {
std::size_t allocations = 0;
}  // namespace

// Counts every allocation in this test program. Not inlined, because compilers would report new and
// delete as mismatched.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}

namespace autoref::strategies {
namespace {

// Makes a team decide in every state of play and counts its allocations.
std::size_t allocated_by(Strategy& team) {
  std::size_t allocated = 0;
  StagedWorld world(Play::kHalt);
  world.six_against_six().ball({0.2, 0.1});
  for (int play = 0; play <= static_cast<int>(Play::kRunning); ++play) {
    for (const bool ours : {true, false}) {
      world.view.play = static_cast<Play>(play);
      world.view.ours = ours;
      for (int frame = 0; frame < 60; ++frame) {
        const std::size_t before = allocations;
        world.step(team);
        allocated += allocations - before;
      }
    }
  }
  return allocated;
}

TEST(Allocations, AreCounted) {
  const std::size_t before = allocations;
  ::operator delete(::operator new(1));  // unlike an expression with new, never optimised away
  EXPECT_EQ(allocations, before + 1);
}

TEST(Allocations, AreNotMadeWhenTeamsDecide) {
  for (const Entry& entry : all_strategies()) {
    const std::unique_ptr<Strategy> team = entry.make(TeamContext{});
    StagedWorld first(Play::kRunning);
    first.six_against_six().step(*team);  // one-time allocations are allowed in this step
    EXPECT_EQ(allocated_by(*team), 0U) << entry.name;
  }
}

}  // namespace
}  // namespace autoref::strategies
