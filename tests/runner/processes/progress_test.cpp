#include "runner/processes/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

namespace autoref::runner {
namespace {

TEST(DurationText, FitsTheLength) {
  EXPECT_EQ(duration_text(9.2), "9 s");
  EXPECT_EQ(duration_text(125), "2 min 05 s");
  EXPECT_EQ(duration_text(3900), "1 h 05 min");
}

TEST(ProgressText, TellsSpeedAndTimeLeft) {
  // 10 games in 20 s: half a game a second; 60 are left.
  EXPECT_EQ(progress_text({.total = 120, .done = 60, .played = 10}, 20),
            "60/120 games   30 games/min   2 min 00 s left");
}

TEST(ProgressText, TellsNoSpeedBeforeTheFirstGame) {
  EXPECT_EQ(progress_text({.total = 120, .done = 60}, 20), "60/120 games");
}

TEST(ProgressText, CountsVoidGamesWhereTheyAreCounted) {
  EXPECT_EQ(progress_text({.total = 5, .done = 5, .played = 5, .voids = 2}, 10),
            "5/5 games   30 games/min   2 void");
}

// A terminal whose screen can be read.
class Terminal {
 public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (grantpt(master_) + unlockpt(master_) != 0) throw std::runtime_error("no terminal");
    setenv("TERM", "xterm", 1);
    stream_ = fdopen(open(ptsname(master_), O_RDWR | O_NOCTTY), "w");
    if (stream_ == nullptr) throw std::runtime_error("no terminal");
  }
  ~Terminal() {
    std::fclose(stream_);
    hang_up();
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  std::FILE* stream() const { return stream_; }
  void hang_up() {
    if (master_ >= 0) close(master_);
    master_ = -1;
  }
  // What has come since the last call; all of it is there when it ends with `end`.
  std::string received(std::string_view end) const {
    std::string text;
    std::array<char, 4096> buffer{};
    pollfd watched{master_, POLLIN, 0};
    while (!text.ends_with(end) && poll(&watched, 1, 2000) > 0) {
      const ssize_t count = read(master_, buffer.data(), buffer.size());
      if (count <= 0) break;
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int master_;
  std::FILE* stream_ = nullptr;
};

TEST(Progress, DrawsABarAndTheTableSoFar) {
  const Terminal terminal;
  Progress progress(terminal.stream(), {.total = 4, .done = 1});
  progress.show([] { return "the table\n"; });
  progress.game_done("1:0");
  const std::string drawn = terminal.received("\033[1A");
  EXPECT_TRUE(drawn.starts_with("\r\033[J[############............] 2/4 games")) << drawn;
  EXPECT_TRUE(drawn.ends_with("\nthe table\r\033[1A")) << drawn;
}

TEST(Progress, MakesTheTableAtMostOnceASecond) {
  const Terminal terminal;
  Progress progress(terminal.stream(), {.total = 4});
  int tables = 0;
  progress.show([&tables] { return std::to_string(++tables); });
  for (int i = 0; i < 4; ++i) progress.game_done("1:0");
  EXPECT_EQ(tables, 1);
}

TEST(Progress, ClearsTheScreenForAMessageAndInTheEnd) {
  const Terminal terminal;
  {
    Progress progress(terminal.stream(), {.total = 2});
    progress.say("a message");
    EXPECT_EQ(terminal.received("\n"), "\r\033[Ja message\r\n");
  }
  EXPECT_EQ(terminal.received("\033[J"), "\r\033[J");
}

TEST(Progress, IsALinePerGameOnADumbTerminal) {
  const Terminal terminal;
  setenv("TERM", "dumb", 1);
  Progress progress(terminal.stream(), {.total = 2});
  progress.show([] { return "the table"; });
  progress.game_done("1:0");
  const std::string line = terminal.received("\n");
  EXPECT_TRUE(line.starts_with("1/2 games")) << line;
  EXPECT_TRUE(line.ends_with("   1:0\r\n")) << line;
  EXPECT_EQ(line.find('\033'), std::string::npos);
}

TEST(Progress, IgnoresATerminalThatIsGone) {
  Terminal terminal;
  Progress progress(terminal.stream(), {.total = 2});
  terminal.hang_up();
  progress.game_done("1:0");
  progress.say("a message");
  EXPECT_NE(std::ferror(terminal.stream()), 0);  // else nothing was tried
}

TEST(Progress, IgnoresAFullDisk) {
  std::FILE* full = std::fopen("/dev/full", "w");
  ASSERT_NE(full, nullptr);
  Progress(full, {.total = 2}).game_done("1:0");
  EXPECT_NE(std::ferror(full), 0);
  std::fclose(full);
}

}  // namespace
}  // namespace autoref::runner
