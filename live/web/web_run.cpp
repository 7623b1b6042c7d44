#include "live/web/web_run.hpp"

#include <algorithm>
#include <utility>

#include "view/page.hpp"

namespace autoref::live {
namespace {

WebText shared_text(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

auto named(const std::string& id) {
  return [&id](const view::ListedGame& game) { return game.id == id; };
}

}  // namespace

WebRun::WebRun(const WebOptions& options, const std::string& title,
               std::function<std::optional<std::string>(const std::string& id)> game_page)
    : start_(shared_text(view::run_start_message(title))),
      progress_(shared_text(view::progress_message({}))),
      results_(shared_text(view::results_message(""))),
      list_(shared_text(view::games_message({}, {}))),
      server_(thread_, options,
              {view::run_page(title), [this] { return backlog(); }, std::move(game_page)}) {}

void WebRun::show(const view::RunProgress& progress) {
  send(progress_, view::progress_message(progress));
  if (is_list_stale_) send_games();
}

void WebRun::show_results(const std::string& html) { send(results_, view::results_message(html)); }
void WebRun::end(const std::string& text) { send(over_, view::over_message(text)); }

void WebRun::start_game(const view::ListedGame& game) {
  if (std::any_of(running_.begin(), running_.end(), named(game.id))) return;
  running_.push_back(game);
  is_list_stale_ = true;
}

std::optional<std::string> WebRun::end_game(const std::string& id, const std::string& text) {
  const auto game = std::find_if(running_.begin(), running_.end(), named(id));
  if (game == running_.end()) return std::nullopt;
  ended_.push_front({id, text, game->has_page});
  running_.erase(game);
  std::optional<std::string> dropped;
  if (ended_.size() > kMostEnded) {
    dropped = ended_.back().id;
    ended_.pop_back();
  }
  is_list_stale_ = true;
  return dropped;
}

void WebRun::send_games() {
  is_list_stale_ = false;
  const auto shown = static_cast<std::ptrdiff_t>(std::min(running_.size(), kMostRunning));
  send(list_, view::games_message({running_.begin(), running_.begin() + shown},
                                  {ended_.begin(), ended_.end()}));
}

WebBacklog WebRun::backlog() const {
  const std::lock_guard lock(mutex_);
  WebBacklog backlog{{start_, progress_, results_, list_}, number_};
  if (over_) backlog.texts.push_back(over_);
  return backlog;
}

// `last` is the newest message of its kind, which new watchers get first.
void WebRun::send(WebText& last, std::string message) {
  const std::lock_guard lock(mutex_);
  last = shared_text(std::move(message));
  server_.send({last, false, ++number_});
}

}  // namespace autoref::live
