// Shows an experiment and its games to watchers on the network while they are played.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "live/network/network.hpp"
#include "live/web/web_server.hpp"
#include "view/live_messages.hpp"

namespace autoref::live {

// Watchers get only the newest message of each kind, so the number and size of the messages do not
// grow with the experiment.
class WebRun {
 public:
  static constexpr std::size_t kMostEnded = 32;    // games listed after their end
  static constexpr std::size_t kMostRunning = 64;  // games listed while they are played

  // `title` is the experiment's description or its name. `game_page` is called in the network's
  // thread. Throws InputError naming --web if the server cannot listen, or --web-host.
  WebRun(const WebOptions& options, const std::string& title,
         std::function<std::optional<std::string>(const std::string& id)> game_page);

  // Sends the progress of the run, and the list of games if it has changed. The list is sent only
  // here because short games begin and end far more often than anybody could read it.
  void show(const view::RunProgress& progress);
  void show_results(const std::string& html);
  // Lists a game as being played. A restarted game is listed only once.
  void start_game(const view::ListedGame& game);
  // Lists a started game with its result. Returns the id of the game that drops out of the list as
  // a result, if any.
  std::optional<std::string> end_game(const std::string& id, const std::string& text);
  void end(const std::string& text);  // `text` is a sentence that says what has ended

  std::string url() const { return server_.url(); }

 private:
  WebBacklog backlog() const;
  void send(WebText& last, std::string message);
  void send_games();

  mutable std::mutex mutex_;
  WebText start_;
  WebText progress_;
  WebText results_;
  WebText list_;
  WebText over_;             // message that the run is over; null until then
  std::int64_t number_ = 0;  // number of messages so far
  std::vector<view::ListedGame> running_;
  std::deque<view::ListedGame> ended_;  // newest first
  bool is_list_stale_ = false;
  NetworkThread thread_;
  WebServer server_;
};

}  // namespace autoref::live
