#include "live/web/web_hub.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace autoref::live {
namespace {

// Maximum number of connections that wait for the end of their answer.
constexpr std::size_t kMostUnanswered = 32;

std::size_t count_of(const std::string& computer, const WebHub::Connections& connections) {
  const auto count = std::count_if(connections.begin(), connections.end(),
                                   [&](const auto& one) { return one->computer() == computer; });
  return static_cast<std::size_t>(count);
}

// The connections of the computer that has most of them. There must be one.
WebHub::Connections of_busiest_computer(WebHub::Connections connections) {
  std::map<std::string, std::size_t> counts;
  for (const auto& connection : connections) ++counts[connection->computer()];
  const auto busiest = std::max_element(
      counts.begin(), counts.end(),
      [](const auto& one, const auto& other) { return one.second < other.second; });
  std::erase_if(connections, [&](const auto& one) { return one->computer() != busiest->first; });
  return connections;
}

}  // namespace

WebHub::WebHub(WebOptions options, WebHosts hosts, WebContent content)
    : options_(std::move(options)), hosts_(std::move(hosts)), content_(std::move(content)) {}

std::optional<std::string> WebHub::game_page(const std::string& id) const {
  return content_.game_page ? content_.game_page(id) : std::nullopt;
}

void WebHub::add(const std::shared_ptr<WebConnection>& connection) {
  if (connection->state() != WebState::kWatching) make_room();
  connections_.push_back(connection);
}

void WebHub::remove(const std::shared_ptr<WebConnection>& connection) {
  std::erase(connections_, connection);
}

void WebHub::drop(const std::shared_ptr<WebConnection>& connection) {
  remove(connection);
  connection->close();
}

// Prevents one computer from keeping others out with connections that request nothing or read no
// answer.
void WebHub::make_room() {
  const Connections unanswered = those_who(false);
  if (unanswered.size() < kMostUnanswered) return;
  const Connections busiest = of_busiest_computer(unanswered);
  const auto silent = std::find_if(busiest.begin(), busiest.end(), [](const auto& connection) {
    return connection->state() == WebState::kSilent;
  });
  drop(silent == busiest.end() ? busiest.front() : *silent);
}

bool WebHub::makes_room_for_watcher(const std::string& computer) {
  if (is_closed_) return false;
  const Connections watchers = those_who(true);
  if (watchers.size() < options_.most_watchers) return true;
  const Connections busiest = of_busiest_computer(watchers);
  // If it had only one more, the two would displace each other forever.
  if (busiest.size() < count_of(computer, watchers) + 2) return false;
  drop(busiest.back());
  return true;
}

// Returns copies, since a closed connection removes itself.
WebHub::Connections WebHub::those_who(bool watch) const {
  Connections chosen;
  std::copy_if(connections_.begin(), connections_.end(), std::back_inserter(chosen),
               [watch](const auto& connection) {
                 return (connection->state() == WebState::kWatching) == watch;
               });
  return chosen;
}

void WebHub::send(const WebMessage& message) {
  for (const auto& watcher : those_who(true)) watcher->push(message);
}

void WebHub::close_watchers() {
  for (const auto& watcher : those_who(true)) watcher->close();
}

void WebHub::close() {
  is_closed_ = true;
  const Connections connections = std::exchange(connections_, {});
  for (const auto& connection : connections) connection->close();
}

}  // namespace autoref::live
