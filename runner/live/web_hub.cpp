#include "runner/live/web_hub.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace autoref::runner {
namespace {

// Connections that may wait with their request while all watchers are connected.
constexpr std::size_t kMostUnanswered = 32;

}  // namespace

WebHub::WebHub(WebOptions options, std::vector<std::string> hosts, WebContent content)
    : options_(std::move(options)), hosts_(std::move(hosts)), content_(std::move(content)) {}

std::optional<std::string> WebHub::game_page(const std::string& id) const {
  return content_.game_page ? content_.game_page(id) : std::nullopt;
}

bool WebHub::has_room() const {
  return !is_closed_ && connections_.size() < options_.most_watchers + kMostUnanswered;
}

bool WebHub::has_room_for_a_watcher() const {
  return !is_closed_ && watchers().size() < options_.most_watchers;
}

void WebHub::add(const std::shared_ptr<WebConnection>& connection) {
  connections_.insert(connection);
}

void WebHub::remove(const std::shared_ptr<WebConnection>& connection) {
  connections_.erase(connection);
}

// Copies, since a watcher that is closed removes itself.
std::vector<std::shared_ptr<WebConnection>> WebHub::watchers() const {
  std::vector<std::shared_ptr<WebConnection>> watchers;
  std::copy_if(connections_.begin(), connections_.end(), std::back_inserter(watchers),
               [](const auto& connection) { return connection->is_watcher(); });
  return watchers;
}

void WebHub::send(const WebMessage& message) {
  for (const auto& watcher : watchers()) watcher->push(message);
}

void WebHub::close_watchers() {
  for (const auto& watcher : watchers()) watcher->close();
}

void WebHub::close() {
  is_closed_ = true;
  const std::set<std::shared_ptr<WebConnection>> connections = std::move(connections_);
  connections_.clear();
  for (const auto& connection : connections) connection->close();
}

}  // namespace autoref::runner
