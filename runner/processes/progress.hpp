// How far an experiment is, on stderr.
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runner/processes/standings_table.hpp"

namespace autoref::runner {

struct GameCounts {
  int total = 0;
  int done = 0;                   // of them, by this run and former ones
  int played = 0;                 // by this run
  std::optional<int> voids = {};  // of those done; none where nobody counts them
};

// "1 h 05 min", "2 min 05 s", "9 s".
std::string duration_text(double seconds);

// "12/120 games   62 games/min   1 min 44 s left   0 void", `elapsed_s` after this run's begin. The
// speed is left out until a game has been played.
std::string progress_text(const GameCounts& counts, double elapsed_s);

// How progress is written.
enum class ProgressStyle {
  kAuto,   // kPlain, but on a terminal a bar and tables that are drawn over; not if TERM is "dumb"
  kPlain,  // a line every few seconds
  kJson,   // likewise, each a JSON object
  kNone,   // messages only
};

// "plain", "json" or "none"; none for other words.
std::optional<ProgressStyle> progress_style_of(std::string_view name);

// What is known of the games so far, besides their counts.
struct ProgressView {
  std::string heading;                                    // a line above the tables
  std::vector<ProgressTable> tables;                      // for a terminal
  std::vector<std::pair<std::string, std::string>> json;  // further members and their values
};

// {"event": "progress", "done": 12, "total": 120, "void": 0, "played": 12, "elapsed_s": 11.6,
//  "games_per_min": 62.1, "left_s": 104.3}, then the view's members. Numbers that are not known
// are null.
std::string progress_json(std::string_view event, const GameCounts& counts, double elapsed_s,
                          const ProgressView& view);

// Writes to a stream until it is destroyed; the last state is written in any case. There are no
// colours.
class Progress {
 public:
  // Nothing is written where `stream` is null.
  explicit Progress(std::FILE* stream, ProgressStyle style = ProgressStyle::kAuto);
  Progress(std::FILE* stream, const GameCounts& counts, ProgressStyle style = ProgressStyle::kAuto);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // What there is to play; may be called again when that changes. `played` is counted here. Before
  // the first call only messages are written.
  void expect(const GameCounts& counts);

  // What is shown besides the counts. `view` is called at most once a second, and seldom enough to
  // take at most a hundredth of the time.
  void show(std::function<ProgressView()> view) { view_of_ = std::move(view); }

  void game_done(bool is_void = false);

  // Writes what is due; to be called several times a second.
  void tick();

  // A message of its own line; {"event": "note", "text": "..."} as JSON.
  void say(const std::string& message);

  // A terminal keeps the tables in the end, not the bar alone.
  void keep_tables() { keeps_tables_ = true; }

 private:
  using Clock = std::chrono::steady_clock;

  double elapsed_s() const;
  std::string bar(const Screen& screen) const;
  std::string tables(const Screen& screen) const;
  void draw();
  void write_line(std::string_view event);
  void renew_view();
  void end();

  std::FILE* stream_;
  ProgressStyle style_;  // kAuto on a terminal alone
  GameCounts counts_;
  bool is_started_ = false;
  bool keeps_tables_ = false;
  std::function<ProgressView()> view_of_;
  ProgressView view_;
  int played_in_view_ = -1;
  int done_in_line_ = -1;
  std::string drawn_;
  Clock::time_point began_ = Clock::now();
  Clock::time_point next_view_ = began_;
  Clock::time_point next_drawing_ = began_;
  Clock::time_point next_line_ = began_;
};

}  // namespace autoref::runner
