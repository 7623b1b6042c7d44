// Reports that workers make about their own games while a benchmark runs.
#pragma once

#include <cstdint>

#include "game/loop/game_record.hpp"

namespace autoref::game {
struct GameConfiguration;
}

namespace autoref::benchmarks {

// Totals over the games of all workers.
struct WorkerCosts {
  std::int64_t games = 0;
  std::int64_t frames = 0;
  double set_up_s = 0;  // processor time to create games, take their records and destroy them
  double frames_s = 0;  // processor time of the games' frames
  // Memory of the largest worker at the end of a game, in MB (10^6 bytes). The first value counts
  // the worker's own pages. The second counts all pages, most of which it shares with its parent
  // and other programs.
  double most_private_mb = 0;
  double most_resident_mb = 0;
};

// Adds up, in shared memory, the costs of games that are played in child processes. Create the
// meter before the child processes.
class WorkerMeter {
 public:
  // Throws InputOutputError if shared memory cannot be created.
  WorkerMeter();
  ~WorkerMeter();
  WorkerMeter(const WorkerMeter&) = delete;
  WorkerMeter& operator=(const WorkerMeter&) = delete;

  // Plays one game, like play(), and adds its costs. Called by workers. `with_memory` also measures
  // the worker's memory, which takes about a millisecond.
  game::GameRecord play(const game::GameConfiguration& game, bool with_memory) const;

  WorkerCosts costs() const;

 private:
  struct Totals;
  Totals* totals_;
};

}  // namespace autoref::benchmarks
