#include "runner/processes/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "runner/io/errors.hpp"
#include "runner/processes/standings_table.hpp"

namespace autoref::runner {
namespace {

// Whether lines can be drawn over there.
bool is_terminal(std::FILE* stream) {
  if (stream == nullptr || isatty(fileno(stream)) != 1) return false;
  const char* const name = std::getenv("TERM");
  return name == nullptr || std::string_view(name) != "dumb";
}

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string progress_text(const GameCounts& counts, double elapsed_s) {
  std::string text = fmt::format("{}/{} games", counts.done, counts.total);
  if (counts.played > 0 && elapsed_s > 0) {
    const double per_s = counts.played / elapsed_s;
    const int left = counts.total - counts.done;
    text += fmt::format("   {:.0f} games/min", 60 * per_s);
    if (left > 0) text += fmt::format("   {} left", duration_text(left / per_s));
  }
  if (counts.voids) text += fmt::format("   {} void", *counts.voids);
  return text;
}

Progress::Progress(std::FILE* stream, const GameCounts& counts)
    : stream_(stream), is_terminal_(is_terminal(stream)), counts_(counts) {}

Progress::~Progress() { clear(); }

void Progress::game_done(const std::string& news, bool is_void) {
  ++counts_.done;
  ++counts_.played;
  if (counts_.voids && is_void) ++*counts_.voids;
  if (stream_ == nullptr) return;
  if (is_terminal_) {
    tick();
  } else {
    say(fmt::format("{}   {}", progress_text(counts_, elapsed_s()), news));
  }
}

void Progress::tick() {
  if (!is_terminal_) return;
  renew_table();
  const std::string bar =
      bar_text(counts_.done, counts_.total) + progress_text(counts_, elapsed_s());
  write_message(stream_, standings_table(bar, table_, screen_of(stream_)));
}

void Progress::renew_table() {
  const Clock::time_point start = Clock::now();
  if (!table_of_ || counts_.played == played_in_table_ || start < next_table_) return;
  table_ = table_of_();
  played_in_table_ = counts_.played;
  const Clock::time_point end = Clock::now();
  next_table_ = end + std::max<Clock::duration>(std::chrono::seconds(1), 100 * (end - start));
}

void Progress::say(const std::string& message) {
  if (stream_ == nullptr) return;
  clear();
  write_message(stream_, message + "\n");
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(Clock::now() - began_).count();
}

void Progress::clear() {
  if (is_terminal_) write_message(stream_, kClearTable);
}

}  // namespace autoref::runner
