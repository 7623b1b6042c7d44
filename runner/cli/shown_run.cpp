#include "runner/cli/shown_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "runner/io/errors.hpp"
#include "runner/report/run_results.hpp"
#include "runner/report/sections.hpp"
#include "runner/results/scores.hpp"

namespace autoref::runner {
namespace {

constexpr std::chrono::milliseconds kTimeForLastMessage{500};

std::string game_text(const std::string& a, const std::string& between, const std::string& b) {
  return fmt::format("{} {} {}", a, between, b);
}

}  // namespace

ShownRun::ShownRun(const Scenario& scenario, const std::string& name, const WebFlags& web,
                   ExperimentOptions& options) {
  if (web.address.empty()) return;
  web_.emplace(web_options_of(web), scenario.about.empty() ? name : scenario.about,
               [this](const std::string& id) { return games_.page(id); });
  set_callbacks(options);
  write_message(stderr, fmt::format("watch at {}\n", web_->url()));
}

void ShownRun::set_callbacks(ExperimentOptions& options) {
  options.publish = [this](const GameCounts& counts, const std::string& text) {
    show_progress(counts, text);
  };
  options.show = [this](const ExperimentResults& results) {
    has_intervals_ = !results.groups.empty();
    web_->show_results(run_results_html(results));
  };
  options.starting = [this](const ScheduledGame& game) { start(game); };
  options.ended = [this](const GameRow& row) { end_game(row); };
}

void ShownRun::show_progress(const GameCounts& counts, const std::string& text) {
  const bool is_interim = has_intervals_ && counts.done < counts.total;
  web_->show({counts.done, counts.total, text, is_interim ? kInterimWarning : ""});
}

void ShownRun::start(const ScheduledGame& game) {
  const bool has_page = games_.add(game);
  web_->start_game({game.id, game_text(game.team_a, ":", game.team_b), has_page});
}

void ShownRun::end_game(const GameRow& row) {
  const std::string text = game_text(row.team_a, score_text(row.record), row.team_b);
  if (const std::optional<std::string> dropped = web_->end_game(row.game_id, text))
    games_.forget(*dropped);
}

void ShownRun::end() {
  if (!web_) return;
  web_->end("The run is over.");
  std::this_thread::sleep_for(kTimeForLastMessage);
}

}  // namespace autoref::runner
