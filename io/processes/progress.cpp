#include "io/processes/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/errors.hpp"
#include "io/terminal.hpp"

namespace autoref::io {
namespace {

constexpr std::chrono::seconds kBetweenLines{5};
constexpr std::chrono::seconds kBetweenDrawings{1};  // time between drawings of the terminal view
constexpr int kRowsAfterwards = 3;  // screen rows left for a two-line message and the prompt

constexpr std::chrono::seconds kBetweenPublished{1};

// Whether the stream is a terminal on which lines can be redrawn.
bool can_redraw(std::FILE* stream) {
  if (stream == nullptr || !is_terminal(stream)) return false;
  const char* const name = std::getenv("TERM");
  return name == nullptr || std::string_view(name) != "dumb";
}

// Games per second; nullopt before the first game.
std::optional<double> rate_of(const GameCounts& counts, double elapsed_s) {
  if (counts.played == 0 || elapsed_s <= 0) return std::nullopt;
  return counts.played / elapsed_s;
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
  if (const std::optional<double> per_s = rate_of(counts, elapsed_s)) {
    const int left = counts.total - counts.done;
    text += fmt::format("   {:.0f} games/min", 60 * *per_s);
    if (left > 0) text += fmt::format("   {} left", duration_text(left / *per_s));
  }
  if (counts.voids) text += fmt::format("   {} void", *counts.voids);
  return text;
}

std::optional<ProgressStyle> progress_style_of(std::string_view name) {
  if (name == "plain") return ProgressStyle::kPlain;
  if (name == "json") return ProgressStyle::kJson;
  if (name == "none") return ProgressStyle::kNone;
  return std::nullopt;
}

std::string progress_json(std::string_view event, const GameCounts& counts, double elapsed_s,
                          const ProgressView& view) {
  const std::optional<double> per_s = rate_of(counts, elapsed_s);
  const int left = counts.total - counts.done;
  Json json = {{"event", event},
               {"done", counts.done},
               {"total", counts.total},
               {"void", counts.voids ? Json(*counts.voids) : Json()},
               {"played", counts.played},
               {"elapsed_s", rounded(elapsed_s, 1)},
               {"games_per_min", per_s ? Json(rounded(60 * *per_s, 1)) : Json()},
               {"left_s", per_s ? Json(rounded(left / *per_s, 1)) : Json()}};
  if (view.json) json.update(*view.json);
  return json_text(json);
}

Progress::Progress(std::FILE* stream, ProgressStyle style) : stream_(stream), style_(style) {
  if (style == ProgressStyle::kAuto && !can_redraw(stream)) style_ = ProgressStyle::kPlain;
}

Progress::Progress(std::FILE* stream, const GameCounts& counts, ProgressStyle style)
    : Progress(stream, style) {
  expect(counts);
}

Progress::~Progress() { end(); }

void Progress::expect(const GameCounts& counts) {
  const int played = counts_.played;
  counts_ = counts;
  counts_.played = played;
  if (is_started_) return;
  is_started_ = true;
  began_ = Clock::now();
  next_line_ = began_ + kBetweenLines;
}

void Progress::game_done(bool is_void) {
  ++counts_.done;
  ++counts_.played;
  if (counts_.voids && is_void) ++*counts_.voids;
  tick();
}

void Progress::tick() {
  publish_counts();
  if (stream_ == nullptr || !is_started_) return;
  if (style_ == ProgressStyle::kAuto) {
    draw();
  } else if (style_ != ProgressStyle::kNone && Clock::now() >= next_line_) {
    write_line("progress");
  }
}

void Progress::draw() {
  renew_view();
  const Screen screen = screen_of(stream_);
  std::string text = standings_table(bar(screen), tables(screen), screen);
  if (text == drawn_ && Clock::now() < next_drawing_) return;
  write_message(stream_, text);
  drawn_ = std::move(text);
  next_drawing_ = Clock::now() + kBetweenDrawings;
}

std::string Progress::bar(const Screen& screen) const {
  return bar_line(counts_.done, counts_.total, progress_text(counts_, elapsed_s()), screen.columns);
}

std::string Progress::tables(const Screen& screen) const {
  const int lines = table_lines(screen) - (view_.heading.empty() ? 0 : 1);
  const std::string text = fitted(view_.tables, lines, screen.columns);
  return text.empty() || view_.heading.empty() ? text : view_.heading + "\n" + text;
}

void Progress::write_line(std::string_view event) {
  next_line_ = Clock::now() + kBetweenLines;
  done_in_line_ = counts_.done;
  if (style_ == ProgressStyle::kJson) {
    renew_view();
    write_message(stream_, progress_json(event, counts_, elapsed_s(), view_) + "\n");
  } else {
    write_message(stream_, progress_text(counts_, elapsed_s()) + "\n");
  }
}

void Progress::publish_counts() {
  if (!publish_ || !is_started_ || Clock::now() < next_publishing_) return;
  next_publishing_ = Clock::now() + kBetweenPublished;
  renew_view();
  publish_(counts_, progress_text(counts_, elapsed_s()));
}

void Progress::renew_view() {
  const Clock::time_point start = Clock::now();
  if (!view_of_ || counts_.played == played_in_view_ || start < next_view_) return;
  view_ = view_of_();
  played_in_view_ = counts_.played;
  const Clock::time_point end = Clock::now();
  next_view_ = end + std::max<Clock::duration>(std::chrono::seconds(1), 100 * (end - start));
}

void Progress::say(const std::string& message) {
  if (stream_ == nullptr) return;
  if (style_ == ProgressStyle::kJson) {
    write_message(stream_, json_text({{"event", "note"}, {"text", message}}) + "\n");
    return;
  }
  const std::string_view clear = style_ == ProgressStyle::kAuto ? kClearTable : "";
  write_message(stream_, fmt::format("{}{}\n", clear, message));
  drawn_.clear();
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(Clock::now() - began_).count();
}

// Writes the final state, no matter how recent the last update was.
void Progress::end() {
  next_publishing_ = Clock::now();
  next_view_ = next_publishing_;
  publish_counts();
  if (stream_ == nullptr || !is_started_ || style_ == ProgressStyle::kNone) return;
  next_view_ = Clock::now();
  if (style_ == ProgressStyle::kAuto) {
    if (keeps_tables_) renew_view();
    Screen screen = screen_of(stream_);
    screen.rows -= kRowsAfterwards;
    write_message(stream_,
                  last_standings_table(bar(screen), keeps_tables_ ? tables(screen) : "", screen));
  } else if (style_ == ProgressStyle::kJson || counts_.done != done_in_line_) {
    write_line("end");
  }
}

}  // namespace autoref::io
