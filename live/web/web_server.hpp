// A web server that shows a game to watchers. It takes nothing from them.
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
  std::chrono::milliseconds header_time{5'000};  // for a request to arrive
  std::chrono::milliseconds write_time{10'000};  // for a watcher to take a message
  std::vector<std::string> further_hosts = {};   // names of this computer (web_request.hpp)
};

// Answers GET / with the page, GET /game?ID with a game's page and GET /live with a WebSocket that
// sends the backlog and then each message (web_request.hpp says which requests are refused). A slow
// watcher misses frames; one that takes nothing for `write_time`, misses other messages or sends
// long messages is disconnected. Connections that wait for an answer are few: a new one takes the
// place of one that has not sent its request, the oldest of the computer that has most. Likewise,
// when as many watch as may, a new watcher takes the place of one of a computer with two more.
class WebServer {
 public:
  // The content's functions are called in the network's thread. Throws InputError naming --web if
  // the port is in use or the address is not this computer's, or --web-host.
  WebServer(NetworkThread& thread, const WebOptions& options, WebContent content);
  ~WebServer();  // disconnects everybody; then the content's functions are not called any more
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  // Hands the message over to the network's thread; never waits for a watcher.
  void send(WebMessage message);

  std::string url() const;
  int port() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace autoref::live
