#include "runner/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace autoref::runner {
namespace {

TEST(DurationText, FitsTheLength) {
  EXPECT_EQ(duration_text(9.2), "9 s");
  EXPECT_EQ(duration_text(125), "2 min 05 s");
  EXPECT_EQ(duration_text(3900), "1 h 05 min");
}

TEST(ProgressText, TellsSpeedAndTimeLeft) {
  // 10 games in 20 s: half a game a second; 60 are left.
  EXPECT_EQ(progress_text(60, 120, 10, 20), "60/120 games   30 games/min   2 min 00 s left");
}

TEST(ProgressText, TellsNoSpeedBeforeTheFirstGame) {
  EXPECT_EQ(progress_text(60, 120, 0, 20), "60/120 games");
}

TEST(Progress, IgnoresATerminalThatIsGone) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  ASSERT_EQ(grantpt(master) + unlockpt(master), 0);
  std::FILE* terminal = fdopen(open(ptsname(master), O_RDWR | O_NOCTTY), "w");
  ASSERT_NE(terminal, nullptr);
  {
    Progress progress(terminal, 2, 0);
    close(master);
    progress.game_done("1:0");
    progress.say("a message");
    EXPECT_NE(std::ferror(terminal), 0);  // else nothing was tried
  }
  std::fclose(terminal);
}

TEST(Progress, IgnoresAFullDisk) {
  std::FILE* full = std::fopen("/dev/full", "w");
  ASSERT_NE(full, nullptr);
  Progress(full, 2, 0).game_done("1:0");
  EXPECT_NE(std::ferror(full), 0);
  std::fclose(full);
}

}  // namespace
}  // namespace autoref::runner
