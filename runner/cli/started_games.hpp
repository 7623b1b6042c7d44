// The newest games of a run, to be looked into while they are played elsewhere.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "runner/experiments/schedule.hpp"

namespace autoref::runner {

// Workers play the games in processes of their own. Since a game repeats bit by bit, its page comes
// from playing it once more here. May be used by several threads.
class StartedGames {
 public:
  // Takes the game, and drops the oldest one if there are `most`. Games of programs and the network
  // are not taken, since those need not repeat; returns whether it was taken.
  bool add(const ScheduledGame& game, std::size_t most);

  // Plays the game to its end, which takes about a second per 20 minutes, and returns its page;
  // nullopt if it was not taken or has been dropped, or if it cannot be played.
  std::optional<std::string> page(const std::string& id) const;

 private:
  std::optional<ScheduledGame> game_named(const std::string& id) const;

  mutable std::mutex mutex_;
  std::deque<ScheduledGame> games_;
};

}  // namespace autoref::runner
