#include "live/network/source_lock.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace autoref::live {
namespace {

TEST(SourceLock, AdmitsOneComputerUntilItIsSilent) {
  const auto start = std::chrono::steady_clock::now();
  SourceLock lock;
  EXPECT_TRUE(lock.admits("10.0.0.1", start));
  EXPECT_FALSE(lock.admits("10.0.0.2", start + std::chrono::milliseconds(1900)));
  EXPECT_TRUE(lock.admits("10.0.0.1", start + std::chrono::milliseconds(1950)));
  EXPECT_FALSE(lock.admits("10.0.0.2", start + std::chrono::milliseconds(3900)));
  EXPECT_TRUE(lock.admits("10.0.0.2", start + std::chrono::milliseconds(3960)));
}

TEST(SourceLock, PacketsWithoutCommandsExcludeNobody) {
  const auto start = std::chrono::steady_clock::now();
  SourceLock lock;
  EXPECT_TRUE(lock.admits("10.0.0.1", start, false));
  EXPECT_TRUE(lock.admits("10.0.0.2", start, true));
  EXPECT_FALSE(lock.admits("10.0.0.1", start, false));
}

}  // namespace
}  // namespace autoref::live
