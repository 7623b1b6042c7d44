// What the connections of a web server share. Used in the network's thread only.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runner/live/web_message.hpp"
#include "runner/live/web_server.hpp"

namespace autoref::runner {

// One open socket.
class WebConnection {
 public:
  virtual ~WebConnection() = default;
  virtual void close() = 0;
  // Whether it is a watcher; those get messages.
  virtual bool is_watcher() const { return false; }
  virtual void push(const WebMessage& /*message*/) {}
};

class WebHub {
 public:
  WebHub(WebOptions options, std::vector<std::string> hosts, WebContent content);

  const WebOptions& options() const { return options_; }
  const std::vector<std::string>& hosts() const { return hosts_; }
  const std::string& page() const { return content_.page; }
  WebBacklog backlog() const { return content_.backlog(); }
  std::optional<std::string> game_page(const std::string& id) const;

  bool has_room() const;  // for one more connection
  bool has_room_for_a_watcher() const;
  void add(const std::shared_ptr<WebConnection>& connection);
  void remove(const std::shared_ptr<WebConnection>& connection);

  void send(const WebMessage& message);  // to all watchers
  void close_watchers();
  void close();  // all connections, for ever
  bool is_closed() const { return is_closed_; }

 private:
  std::vector<std::shared_ptr<WebConnection>> watchers() const;

  WebOptions options_;
  std::vector<std::string> hosts_;
  WebContent content_;
  std::set<std::shared_ptr<WebConnection>> connections_;
  bool is_closed_ = false;
};

}  // namespace autoref::runner
