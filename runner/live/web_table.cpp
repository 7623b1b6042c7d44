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

WebTable::WebTable(const Address& address)
    : start_(shared_text(table_start_message())),
      last_{shared_text(table_message("")), false, 1},
      server_(thread_, {address}, table_page(), [this] { return backlog(); }) {}

void WebTable::show(const std::string& text) { send(table_message(text)); }
void WebTable::end(const std::string& text) { send(over_message(text)); }

WebBacklog WebTable::backlog() const {
  const std::lock_guard lock(mutex_);
  return {{start_, last_.text}, last_.number};
}

void WebTable::send(std::string message) {
  const std::lock_guard lock(mutex_);
  last_ = {shared_text(std::move(message)), false, last_.number + 1};
  server_.send(last_);
}

}  // namespace autoref::runner
