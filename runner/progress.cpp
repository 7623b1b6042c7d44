#include "runner/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "runner/errors.hpp"

namespace autoref::runner {

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string progress_text(int done, int total, int played, double elapsed_s) {
  std::string text = fmt::format("{}/{} games", done, total);
  if (played == 0 || !(elapsed_s > 0)) return text;
  const double per_s = played / elapsed_s;
  text += fmt::format("   {:.0f} games/min", 60 * per_s);
  if (done < total) text += fmt::format("   {} left", duration_text((total - done) / per_s));
  return text;
}

Progress::Progress(std::FILE* stream, int total, int done)
    : stream_(stream),
      is_terminal_(stream != nullptr && isatty(fileno(stream)) == 1),
      total_(total),
      done_(done) {}

Progress::~Progress() { clear_line(); }

void Progress::game_done(const std::string& news) {
  ++done_;
  ++played_;
  if (stream_ == nullptr) return;
  if (is_terminal_) {
    tick();
  } else {
    say(fmt::format("{}   {}", progress_text(done_, total_, played_, elapsed_s()), news));
  }
}

void Progress::tick() {
  if (!is_terminal_) return;
  constexpr int kWidth = 24;
  const int filled = total_ == 0 ? kWidth : kWidth * done_ / total_;
  clear_line();
  tell(stream_, fmt::format("[{:#<{}}{:.<{}}] {}", "", filled, "", kWidth - filled,
                            progress_text(done_, total_, played_, elapsed_s())));
}

void Progress::say(const std::string& message) {
  if (stream_ == nullptr) return;
  clear_line();
  tell(stream_, message + "\n");
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(Clock::now() - began_).count();
}

void Progress::clear_line() {
  if (is_terminal_) tell(stream_, "\r\033[K");
}

}  // namespace autoref::runner
