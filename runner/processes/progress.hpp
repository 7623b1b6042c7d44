// How far an experiment is, on stderr.
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

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

// Writes to a stream: on a terminal a bar and a table that are drawn over, else a line per game; so
// too where TERM is "dumb". There are no colours.
class Progress {
 public:
  // Nothing is written where `stream` is null.
  Progress(std::FILE* stream, const GameCounts& counts);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // What a terminal shows below the bar. `table` is called as games end, at most once a second, and
  // seldom enough to take at most a hundredth of the time.
  void show(std::function<std::string()> table) { table_of_ = std::move(table); }

  // `news` is what the game came to, such as "b.handicap=0.8-p0007-2 3:1".
  void game_done(const std::string& news, bool is_void = false);

  // Refreshes a terminal.
  void tick();

  // A message of its own line.
  void say(const std::string& message);

 private:
  using Clock = std::chrono::steady_clock;

  double elapsed_s() const;
  void renew_table();
  void clear();

  std::FILE* stream_;
  bool is_terminal_;
  GameCounts counts_;
  std::function<std::string()> table_of_;
  std::string table_;
  int played_in_table_ = -1;
  Clock::time_point began_ = Clock::now();
  Clock::time_point next_table_ = began_;
};

}  // namespace autoref::runner
