// Shows a text that changes, such as a table of standings, to watchers on the network.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "runner/live/network.hpp"
#include "runner/live/web_server.hpp"

namespace autoref::runner {

class WebTable {
 public:
  // Throws InputError naming --web if the server cannot listen.
  explicit WebTable(const Address& address);

  void show(const std::string& text);
  void end(const std::string& text);  // `text` is a sentence that says what is over

  std::string url() const { return server_.url(); }

 private:
  WebBacklog backlog() const;
  void send(std::string message);

  mutable std::mutex mutex_;
  WebText start_;
  WebMessage last_;
  NetworkThread thread_;
  WebServer server_;
};

}  // namespace autoref::runner
