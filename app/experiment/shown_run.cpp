#include "app/experiment/shown_run.hpp"

#include <fmt/format.h>
#include <chrono>
#include <exception>
#include <thread>

#include "app/game/page_recorder.hpp"
#include "experiments/report/run_results.hpp"
#include "experiments/report/sections.hpp"
#include "experiments/results/game_row.hpp"
#include "game/loop/game.hpp"
#include "game/team_programs/program_games.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

constexpr std::chrono::milliseconds kTimeForLastMessage{500};

std::string game_text(const std::string& a, const std::string& between, const std::string& b) {
  return fmt::format("{} {} {}", a, between, b);
}

}  // namespace

bool StartedGames::add(const experiments::ScheduledGame& game) {
  if (game::has_programs(experiments::resolved(game))) return false;
  const std::lock_guard lock(mutex_);
  games_.insert_or_assign(game.id, game);
  return true;
}

void StartedGames::forget(const std::string& id) {
  const std::lock_guard lock(mutex_);
  games_.erase(id);
}

std::optional<experiments::ScheduledGame> StartedGames::game_named(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto game = games_.find(id);
  return game == games_.end() ? std::nullopt : std::optional(game->second);
}

std::optional<std::string> StartedGames::page(const std::string& id) const {
  const std::optional<experiments::ScheduledGame> game = game_named(id);
  if (!game) return std::nullopt;
  try {
    const game::GameConfiguration configuration = experiments::resolved(*game);
    PageRecorder recorder(configuration);
    const game::GameRecord record = game::play(configuration, &recorder);
    return recorder.page(record);
  } catch (const std::exception&) {
    return std::nullopt;  // the run reports why: its game is void for the same reason
  }
}

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
    has_intervals_ = !results.groups.empty() && !results.comparison;
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
