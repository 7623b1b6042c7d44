#include "runner/live/web_table.hpp"

#include <utility>

#include "runner/view/live_messages.hpp"
#include "runner/view/page.hpp"

namespace autoref::runner {

namespace {

WebText shared_text(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

}  // namespace

WebTable::WebTable(const WebOptions& options,
                   std::function<std::optional<std::string>(const std::string& id)> game_page)
    : start_(shared_text(table_start_message())),
      table_(shared_text(table_message(""))),
      games_(shared_text(games_message({}))),
      server_(thread_, options,
              {table_page(), [this] { return backlog(); }, std::move(game_page)}) {}

void WebTable::show(const std::string& text) { send(table_, table_message(text)); }
void WebTable::end(const std::string& text) { send(table_, over_message(text)); }

void WebTable::add_game(const std::string& id) {
  ids_.push_front(id);
  if (ids_.size() > kMostGames) ids_.pop_back();
  send(games_, games_message({ids_.begin(), ids_.end()}));
}

WebBacklog WebTable::backlog() const {
  const std::lock_guard lock(mutex_);
  return {{start_, games_, table_}, number_};
}

// `last` is the newest message of its kind, which new watchers get first.
void WebTable::send(WebText& last, std::string message) {
  const std::lock_guard lock(mutex_);
  last = shared_text(std::move(message));
  server_.send({last, false, ++number_});
}

}  // namespace autoref::runner
