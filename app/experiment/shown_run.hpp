// A run shown in the browser, with the games that it has started.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "app/network_flags.hpp"
#include "experiments/run/run_experiment.hpp"
#include "experiments/schedule/schedule.hpp"
#include "live/web/web_run.hpp"

namespace autoref::app {

// The games that the run has started. Workers play them in processes of their own. Since a game
// repeats bit by bit, its page comes from playing it once more here. May be used by several
// threads.
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

class ShownRun {
 public:
  // Shows the experiment at `web`, and says so on stderr; nowhere if its address is empty. Sets the
  // callbacks of `options`, which must not be called after this object's end. `name` is the title
  // of a scenario that says nothing about itself. Throws InputError naming --web or --web-host.
  ShownRun(const experiments::Scenario& scenario, const std::string& name, const WebFlags& web,
           experiments::ExperimentOptions& options);
  ShownRun(const ShownRun&) = delete;
  ShownRun& operator=(const ShownRun&) = delete;

  // Says that the run is over, and leaves some time for the message to arrive.
  void end();

 private:
  void set_callbacks(experiments::ExperimentOptions& options);
  void show_progress(const io::GameCounts& counts, const std::string& text);
  void start(const experiments::ScheduledGame& game);
  void end_game(const experiments::GameRow& row);

  bool has_intervals_ = false;
  StartedGames games_;
  std::optional<live::WebRun> web_;
};

}  // namespace autoref::app
