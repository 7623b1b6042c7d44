#include "io/processes/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace autoref::io {
namespace {

TEST(DurationText, FitsTheLength) {
  EXPECT_EQ(duration_text(9.2), "9 s");
  EXPECT_EQ(duration_text(125), "2 min 05 s");
  EXPECT_EQ(duration_text(3900), "1 h 05 min");
}

TEST(ProgressText, ShowsSpeedAndTimeLeft) {
  // This run has played 10 games in 20 s, or 0.5 games/s; 60 games are left.
  EXPECT_EQ(progress_text({.total = 120, .done = 60, .played = 10}, 20),
            "60/120 games   30 games/min   2 min 00 s left");
}

TEST(ProgressText, ShowsNoSpeedBeforeTheFirstGame) {
  EXPECT_EQ(progress_text({.total = 120, .done = 60}, 20), "60/120 games");
}

TEST(ProgressText, ShowsVoidGamesIfTheyAreCounted) {
  EXPECT_EQ(progress_text({.total = 5, .done = 5, .played = 5, .voids = 2}, 10),
            "5/5 games   30 games/min   2 void");
}

using SteadyClock = std::chrono::steady_clock;

// Normally 0.
std::int64_t whole_seconds_since(SteadyClock::time_point start) {
  return std::chrono::floor<std::chrono::seconds>(SteadyClock::now() - start).count();
}

// A pseudoterminal whose output can be read.
class Terminal {
 public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (grantpt(master_) + unlockpt(master_) != 0) throw std::runtime_error("no terminal");
    set_type("xterm");
    stream_ = fdopen(open(ptsname(master_), O_RDWR | O_NOCTTY), "w");
    if (stream_ == nullptr) throw std::runtime_error("no terminal");
  }
  ~Terminal() {
    std::fclose(stream_);
    hang_up();
    former_type_ ? setenv("TERM", former_type_->c_str(), 1) : unsetenv("TERM");
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  std::FILE* stream() const { return stream_; }
  static void set_type(const char* type) { setenv("TERM", type, 1); }
  void resize(unsigned short rows, unsigned short columns) const {
    const winsize size{rows, columns, 0, 0};
    if (ioctl(master_, TIOCSWINSZ, &size) != 0) throw std::runtime_error("no size");
  }
  void hang_up() {
    if (master_ >= 0) close(master_);
    master_ = -1;
  }
  // Returns the output since the last call, waiting until it ends with `end`.
  std::string received(std::string_view end) const {
    std::string text;
    std::array<char, 4096> buffer{};
    pollfd watched{master_, POLLIN, 0};
    while (!text.ends_with(end) && poll(&watched, 1, 60'000) > 0) {
      const ssize_t count = read(master_, buffer.data(), buffer.size());
      if (count <= 0) break;
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  static std::optional<std::string> type() {
    const char* const type = std::getenv("TERM");
    return type == nullptr ? std::nullopt : std::optional<std::string>(type);
  }

  std::optional<std::string> former_type_ = type();
  int master_;
  std::FILE* stream_ = nullptr;
};

// A view of one small table.
ProgressView small_view() { return {"so far:", {{{{"team", "points"}, {"zone", "3"}}}}, {}}; }

TEST(Progress, DrawsABarAndTheTablesSoFar) {
  const Terminal terminal;
  Progress progress(terminal.stream(), {.total = 4, .done = 1});
  progress.show(small_view);
  progress.game_done();
  const std::string drawn = terminal.received("\033[3A");
  EXPECT_TRUE(drawn.starts_with("\r\033[J[############............] 2/4 games")) << drawn;
  EXPECT_TRUE(drawn.ends_with("\nso far:\r\nteam   points\r\nzone        3\r\033[3A")) << drawn;
}

TEST(Progress, UpdatesTheTablesAtMostOnceASecond) {
  const Terminal terminal;
  Progress progress(terminal.stream(), {.total = 4});
  int views = 0;
  progress.show([&views] {
    ++views;
    return small_view();
  });
  const SteadyClock::time_point start = SteadyClock::now();
  for (int i = 0; i < 4; ++i) progress.game_done();
  EXPECT_GE(views, 1);
  EXPECT_LE(views, 1 + whole_seconds_since(start));
}

TEST(Progress, ClearsTheScreenForAMessage) {
  const Terminal terminal;
  Progress progress(terminal.stream(), {.total = 2});
  progress.say("a message");
  EXPECT_EQ(terminal.received("\n"), "\r\033[Ja message\r\n");
}

TEST(Progress, LeavesTheBarAtTheEnd) {
  const Terminal terminal;
  {
    Progress progress(terminal.stream(), {.total = 2, .done = 2});
    progress.show(small_view);
  }
  EXPECT_EQ(terminal.received("\n"), "\r\033[J[########################] 2/2 games\r\n");
}

TEST(Progress, LeavesTheTablesIfInterrupted) {
  const Terminal terminal;
  {
    Progress progress(terminal.stream(), {.total = 2, .done = 1});
    progress.show(small_view);
    progress.keep_tables();
  }
  const std::string drawn = terminal.received("zone        3\r\n");
  EXPECT_TRUE(drawn.ends_with("1/2 games\r\nso far:\r\nteam   points\r\nzone        3\r\n"))
      << drawn;
}

TEST(Progress, FollowsTheSizeOfTheTerminal) {
  const Terminal terminal;
  Progress progress(terminal.stream(), {.total = 4});
  progress.show(small_view);
  progress.tick();
  EXPECT_TRUE(terminal.received("\033[3A").ends_with("zone        3\r\033[3A"));
  terminal.resize(20, 12);
  progress.tick();
  const std::string narrow = terminal.received("\033[3A");
  EXPECT_EQ(narrow, "\r\033[J0/4 games\r\nso far:\r\nteam\r\nzone\r\033[3A");
}

// Returns what `write` writes to a file.
std::string written(const std::function<void(std::FILE*)>& write) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* const stream = open_memstream(&text, &size);
  write(stream);
  std::fclose(stream);
  std::string all(text, size);
  std::free(text);
  return all;
}

TEST(Progress, WritesALineEveryFewSecondsToAPipe) {
  const SteadyClock::time_point start = SteadyClock::now();
  const std::string lines = written([](std::FILE* stream) {
    Progress progress(stream, {.total = 100});
    for (int i = 0; i < 50; ++i) progress.game_done();
    progress.tick();
  });
  EXPECT_LE(std::count(lines.begin(), lines.end(), '\n'), 1 + whole_seconds_since(start) / 5)
      << lines;
  const std::size_t last = lines.substr(0, lines.size() - 1).rfind('\n') + 1;
  EXPECT_TRUE(lines.substr(last).starts_with("50/100 games   ")) << lines;  // the final state
}

TEST(Progress, WritesOnlyMessagesInStyleNone) {
  EXPECT_EQ(written([](std::FILE* stream) {
              Progress progress(stream, {.total = 100}, ProgressStyle::kNone);
              progress.game_done();
              progress.say("a message");
            }),
            "a message\n");
}

TEST(Progress, WritesOneJsonObjectPerLine) {
  const std::string lines = written([](std::FILE* stream) {
    Progress progress(stream, {.total = 3, .done = 1, .voids = 0}, ProgressStyle::kJson);
    progress.show([] {
      return ProgressView{"", {}, std::make_shared<Json>(Json{{"groups", Json::array()}})};
    });
    progress.say("say \"x\"");
    progress.game_done(true);
  });
  EXPECT_TRUE(
      lines.starts_with("{\"event\": \"note\", \"text\": \"say \\\"x\\\"\"}\n"
                        "{\"event\": \"end\", \"done\": 2, \"total\": 3, \"void\": 1, "
                        "\"played\": 1, \"elapsed_s\": "))
      << lines;
  EXPECT_TRUE(lines.ends_with(", \"groups\": []}\n")) << lines;
}

TEST(ProgressJson, HasRateAndTimeLeftOnceTheyAreKnown) {
  EXPECT_EQ(
      progress_json("progress", {.total = 120, .done = 60, .played = 10}, 20, {}),
      "{\"event\": \"progress\", \"done\": 60, \"total\": 120, \"void\": null, \"played\": 10, "
      "\"elapsed_s\": 20, \"games_per_min\": 30, \"left_s\": 120}");
  EXPECT_EQ(progress_json("progress", {.total = 2}, 0, {}),
            "{\"event\": \"progress\", \"done\": 0, \"total\": 2, \"void\": null, \"played\": 0, "
            "\"elapsed_s\": 0, \"games_per_min\": null, \"left_s\": null}");
}

TEST(Progress, IsPublishedWithoutAStream) {
  std::string published;
  GameCounts published_counts;
  int views = 0;
  {
    Progress progress(nullptr, {.total = 3});
    progress.publish([&](const GameCounts& counts, const std::string& text) {
      EXPECT_GT(views, 0);  // a page that shows both must not be behind
      published_counts = counts;
      published = text;
    });
    progress.show([&views] {
      ++views;
      return ProgressView{};
    });
    progress.game_done();
  }
  EXPECT_TRUE(published.starts_with("1/3 games")) << published;
  EXPECT_EQ(published_counts.done, 1);
  EXPECT_EQ(published_counts.total, 3);
}

TEST(Progress, IsPlainOnADumbTerminal) {
  const Terminal terminal;
  Terminal::set_type("dumb");
  {
    Progress progress(terminal.stream(), {.total = 2});
    progress.show(small_view);
    progress.game_done();
  }
  const std::string line = terminal.received("\n");
  EXPECT_TRUE(line.starts_with("1/2 games")) << line;
  EXPECT_EQ(line.find('\033'), std::string::npos);
}

TEST(Progress, IgnoresATerminalThatIsGone) {
  Terminal terminal;
  Progress progress(terminal.stream(), {.total = 2});
  terminal.hang_up();
  progress.game_done();
  progress.say("a message");
  EXPECT_NE(std::ferror(terminal.stream()), 0);  // otherwise nothing was tested
}

TEST(Progress, IgnoresAFullDisk) {
  std::FILE* full = std::fopen("/dev/full", "w");
  ASSERT_NE(full, nullptr);
  Progress(full, {.total = 2}).game_done();
  EXPECT_NE(std::ferror(full), 0);
  std::fclose(full);
}

}  // namespace
}  // namespace autoref::io
