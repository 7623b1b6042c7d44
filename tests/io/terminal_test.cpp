#include "io/terminal.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

#include "io/table.hpp"

namespace autoref::io {
namespace {

// A terminal of this width (0: unknown), with COLUMNS as given.
class SizedTerminal {
 public:
  SizedTerminal(unsigned short columns, const char* in_environment)
      : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (grantpt(master_) + unlockpt(master_) != 0) throw std::runtime_error("no terminal");
    stream_ = fdopen(open(ptsname(master_), O_RDWR | O_NOCTTY), "w");
    const winsize size{24, columns, 0, 0};
    if (stream_ == nullptr || ioctl(master_, TIOCSWINSZ, &size) != 0)
      throw std::runtime_error("no terminal");
    if (const char* const former = std::getenv("COLUMNS")) former_ = former;
    in_environment == nullptr ? unsetenv("COLUMNS") : setenv("COLUMNS", in_environment, 1);
  }
  ~SizedTerminal() {
    std::fclose(stream_);
    close(master_);
    former_ ? setenv("COLUMNS", former_->c_str(), 1) : unsetenv("COLUMNS");
  }
  SizedTerminal(const SizedTerminal&) = delete;
  SizedTerminal& operator=(const SizedTerminal&) = delete;

  std::size_t width() const { return text_width(stream_); }

 private:
  int master_;
  std::FILE* stream_ = nullptr;
  std::optional<std::string> former_;
};

TEST(TextWidth, IsThatOfTheTerminal) {
  EXPECT_EQ(SizedTerminal(132, nullptr).width(), 132U);
  EXPECT_EQ(SizedTerminal(132, "nonsense").width(), 132U);
}

TEST(TextWidth, IsFirstWhatTheEnvironmentSays) { EXPECT_EQ(SizedTerminal(132, "70").width(), 70U); }

TEST(TextWidth, Is80IfNobodyKnowsAndAtLeast40) {
  EXPECT_EQ(SizedTerminal(0, nullptr).width(), 80U);
  EXPECT_EQ(SizedTerminal(10, nullptr).width(), 40U);
}

TEST(TextWidth, IsTheSameForAllFiles) {
  const SizedTerminal unused(132, "70");
  std::FILE* const file = std::tmpfile();
  EXPECT_EQ(text_width(file), kTextWidth);
  EXPECT_EQ(kTextWidth, 100U);
  std::fclose(file);
}

}  // namespace
}  // namespace autoref::io
