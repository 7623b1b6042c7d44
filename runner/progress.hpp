// How far an experiment is, on stderr.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace autoref::runner {

// "1 h 05 min", "2 min 05 s", "9 s".
std::string duration_text(double seconds);

// "12/120 games   62 games/min   1 min 44 s left" for `played` games in `elapsed_s`, of which the
// others up to `done` were there before. The speed is left out until a game has been played.
std::string progress_text(int done, int total, int played, double elapsed_s);

// Writes to a stream: a line that is written over on a terminal, else a line per game.
class Progress {
 public:
  // Nothing is written where `stream` is null. `done` games are there already.
  Progress(std::FILE* stream, int total, int done);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `news` is what the game came to, such as "b.handicap=0.8-p0007-2 3:1".
  void game_done(const std::string& news);

  // Refreshes the line of a terminal.
  void tick();

  // A message of its own line.
  void say(const std::string& message);

 private:
  using Clock = std::chrono::steady_clock;

  double elapsed_s() const;
  void clear_line();

  std::FILE* stream_;
  bool is_terminal_;
  int total_;
  int done_;
  int played_ = 0;
  Clock::time_point began_ = Clock::now();
};

}  // namespace autoref::runner
