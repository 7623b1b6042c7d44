// An experiment on the network (--web), while its games are played.
#pragma once

#include <optional>
#include <string>

#include "runner/batch/run_experiment.hpp"
#include "runner/cli/started_games.hpp"
#include "runner/cli/web_flags.hpp"
#include "runner/live/web_run.hpp"

namespace autoref::runner {

class ShownRun {
 public:
  // Shows the experiment at `web`, and says so on stderr; nowhere if its address is empty. Sets the
  // callbacks of `options`, which must not be called after this object's end. `name` is the title
  // of a scenario that says nothing about itself. Throws InputError naming --web or --web-host.
  ShownRun(const Scenario& scenario, const std::string& name, const WebFlags& web,
           ExperimentOptions& options);
  ShownRun(const ShownRun&) = delete;
  ShownRun& operator=(const ShownRun&) = delete;

  // Says that the run is over, and leaves some time for the message to arrive.
  void end();

 private:
  void set_callbacks(ExperimentOptions& options);
  void show_progress(const GameCounts& counts, const std::string& text);
  void start(const ScheduledGame& game);
  void end_game(const GameRow& row);

  bool has_intervals_ = false;
  StartedGames games_;
  std::optional<WebRun> web_;
};

}  // namespace autoref::runner
