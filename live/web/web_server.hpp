// A web server that shows a game to watchers. It accepts no input from them.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "live/network/network.hpp"
#include "live/web/web_message.hpp"

namespace autoref::live {

struct WebOptions {
  Address address{kLoopback, 0};  // port 0: any free port
  std::size_t most_watchers = 32;
  std::chrono::milliseconds header_time{5'000};  // time limit for a request to arrive
  std::chrono::milliseconds write_time{10'000};  // time limit for a watcher to take a message
  std::vector<std::string> further_hosts = {};   // names of this computer (web_request.hpp)
};

// Answers GET / with the page, GET /game?ID with a game's page and GET /live with a WebSocket that
// sends the backlog and then each message (web_request.hpp says which requests are refused). A slow
// watcher misses frames. It is disconnected if it accepts nothing for `write_time`, misses other
// messages or sends long messages. The number of connections waiting for an answer is limited.
// When the limit is reached, a new connection replaces one that has not sent its request: the
// oldest one from the computer that has most of them. Similarly, when the maximum number of
// watchers is reached, a new watcher replaces one from a computer that has at least two more
// watchers than its own.
class WebServer {
 public:
  // The content's functions are called in the network's thread. Throws InputError naming --web if
  // the port is in use or the address is not one of this computer. Throws InputError naming
  // --web-host if a further host name is invalid.
  WebServer(NetworkThread& thread, const WebOptions& options, WebContent content);
  ~WebServer();  // disconnects all; then the content's functions are no longer called
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  // Passes the message to the network's thread; never waits for a watcher.
  void send(WebMessage message);

  std::string url() const;
  int port() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace autoref::live
