// Shows a run in the browser, including the games that it has started.
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

// The games that the run has started. Workers play them in their own processes. Since games are
// reproducible bit for bit, the page of a game is made by playing the game once more in this
// process. Thread-safe.
class StartedGames {
 public:
  // Adds the game and returns true. Returns false for games with programs or the network, which are
  // not necessarily reproducible.
  bool add(const experiments::ScheduledGame& game);
  void forget(const std::string& id);

  // Plays the game to its end and returns its page. Playing takes about a second per 20 simulated
  // minutes. Returns nullopt if the game was not added, has been forgotten or cannot be played.
  std::optional<std::string> page(const std::string& id) const;

 private:
  std::optional<experiments::ScheduledGame> game_named(const std::string& id) const;

  mutable std::mutex mutex_;
  std::map<std::string, experiments::ScheduledGame> games_;  // started games by id
};

class ShownRun {
 public:
  // Shows the experiment at `web` and reports the address on stderr. Does neither if the address is
  // empty. Sets the callbacks of `options`, which must not be called after this object is
  // destroyed. `name` is the title if the scenario has no description. Throws InputError naming
  // --web or --web-host.
  ShownRun(const experiments::Scenario& scenario, const std::string& name, const WebFlags& web,
           experiments::ExperimentOptions& options);
  ShownRun(const ShownRun&) = delete;
  ShownRun& operator=(const ShownRun&) = delete;

  // Announces that the run is over and gives the message some time to arrive.
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
