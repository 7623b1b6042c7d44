// Shows a text that changes, such as a table of standings, and pages of games to watchers on the
// network.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "runner/live/network.hpp"
#include "runner/live/web_server.hpp"

namespace autoref::runner {

class WebTable {
 public:
  static constexpr std::size_t kMostGames = 32;

  // `game_page` is called in the network's thread. Throws InputError naming --web if the server
  // cannot listen, or --web-host.
  WebTable(const WebOptions& options,
           std::function<std::optional<std::string>(const std::string& id)> game_page);

  void show(const std::string& text);
  void add_game(const std::string& id);  // lists the newest games, at most kMostGames
  void end(const std::string& text);     // `text` is a sentence that says what is over

  std::string url() const { return server_.url(); }

 private:
  WebBacklog backlog() const;
  void send(WebText& last, std::string message);

  mutable std::mutex mutex_;
  WebText start_;
  WebText table_;
  WebText games_;
  std::int64_t number_ = 0;      // of messages
  std::deque<std::string> ids_;  // newest first
  NetworkThread thread_;
  WebServer server_;
};

}  // namespace autoref::runner
