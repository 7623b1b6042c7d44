// An experiment on the network (--web), while its games are played.
#pragma once

#include <optional>
#include <string>

#include "app/experiment/started_games.hpp"
#include "app/web_flags.hpp"
#include "experiments/run/run_experiment.hpp"
#include "live/web/web_run.hpp"

namespace autoref::app {

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
