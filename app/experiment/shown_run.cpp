#include "app/experiment/shown_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "experiments/report/run_results.hpp"
#include "experiments/report/sections.hpp"
#include "experiments/results/scores.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

constexpr std::chrono::milliseconds kTimeForLastMessage{500};

std::string game_text(const std::string& a, const std::string& between, const std::string& b) {
  return fmt::format("{} {} {}", a, between, b);
}

}  // namespace

ShownRun::ShownRun(const experiments::Scenario& scenario, const std::string& name,
                   const WebFlags& web, experiments::ExperimentOptions& options) {
  if (web.address.empty()) return;
  web_.emplace(web_options_of(web), scenario.about.empty() ? name : scenario.about,
               [this](const std::string& id) { return games_.page(id); });
  set_callbacks(options);
  io::write_message(stderr, fmt::format("watch at {}\n", web_->url()));
}

void ShownRun::set_callbacks(experiments::ExperimentOptions& options) {
  options.publish = [this](const io::GameCounts& counts, const std::string& text) {
    show_progress(counts, text);
  };
  options.show = [this](const experiments::ExperimentResults& results) {
    has_intervals_ = !results.groups.empty();
    web_->show_results(experiments::run_results_html(results));
  };
  options.starting = [this](const experiments::ScheduledGame& game) { start(game); };
  options.ended = [this](const experiments::GameRow& row) { end_game(row); };
}

void ShownRun::show_progress(const io::GameCounts& counts, const std::string& text) {
  const bool is_interim = has_intervals_ && counts.done < counts.total;
  web_->show({counts.done, counts.total, text, is_interim ? experiments::kInterimWarning : ""});
}

void ShownRun::start(const experiments::ScheduledGame& game) {
  const bool has_page = games_.add(game);
  web_->start_game({game.id, game_text(game.team_a, ":", game.team_b), has_page});
}

void ShownRun::end_game(const experiments::GameRow& row) {
  const std::string text = game_text(row.team_a, experiments::score_text(row.record), row.team_b);
  if (const std::optional<std::string> dropped = web_->end_game(row.game_id, text))
    games_.forget(*dropped);
}

void ShownRun::end() {
  if (!web_) return;
  web_->end("The run is over.");
  std::this_thread::sleep_for(kTimeForLastMessage);
}

}  // namespace autoref::app
