// Games of a run, to be looked into while they are played elsewhere or afterwards.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "experiments/schedule/schedule.hpp"

namespace autoref::app {

// Workers play the games in processes of their own. Since a game repeats bit by bit, its page comes
// from playing it once more here. May be used by several threads.
class StartedGames {
 public:
  // Takes the game. Games of programs and the network are not taken, since those need not repeat;
  // returns whether it was taken.
  bool add(const experiments::ScheduledGame& game);
  void forget(const std::string& id);

  // Plays the game to its end, which takes about a second per 20 minutes, and returns its page;
  // nullopt if it was not taken or has been forgotten, or if it cannot be played.
  std::optional<std::string> page(const std::string& id) const;

 private:
  std::optional<experiments::ScheduledGame> game_named(const std::string& id) const;

  mutable std::mutex mutex_;
  std::map<std::string, experiments::ScheduledGame> games_;  // by id
};

}  // namespace autoref::app
