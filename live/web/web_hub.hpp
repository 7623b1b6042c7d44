// The state shared by the connections of a web server. Used only in the network's thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "live/web/web_message.hpp"
#include "live/web/web_request.hpp"
#include "live/web/web_server.hpp"

namespace autoref::live {

enum class WebState {
  kSilent,    // the client has not sent its request
  kAnswered,  // the answer is being sent
  kWatching,  // the client gets messages
};

// One open socket.
class WebConnection {
 public:
  explicit WebConnection(std::string computer) : computer_(std::move(computer)) {}
  virtual ~WebConnection() = default;
  WebConnection(const WebConnection&) = delete;
  WebConnection& operator=(const WebConnection&) = delete;

  // Address of the client's computer, without port.
  const std::string& computer() const { return computer_; }
  virtual void close() = 0;
  virtual WebState state() const = 0;
  virtual void push(const WebMessage& /*message*/) {}

 private:
  std::string computer_;
};

class WebHub {
 public:
  using Connections = std::vector<std::shared_ptr<WebConnection>>;

  WebHub(WebOptions options, WebHosts hosts, WebContent content);

  const WebOptions& options() const { return options_; }
  const WebHosts& hosts() const { return hosts_; }
  const std::string& page() const { return content_.page; }
  WebBacklog backlog() const { return content_.backlog(); }
  std::optional<std::string> game_page(const std::string& id) const;

  // Adds a watcher or a connection that has not sent anything yet; if there is no room for it,
  // another connection is closed.
  void add(const std::shared_ptr<WebConnection>& connection);
  // Returns whether one more watcher from this computer can be added. To make room for it, another
  // watcher may be disconnected.
  bool makes_room_for_watcher(const std::string& computer);
  void remove(const std::shared_ptr<WebConnection>& connection);

  void send(const WebMessage& message);  // sends the message to all watchers
  void close_watchers();
  void close();  // all connections, permanently
  bool is_closed() const { return is_closed_; }

 private:
  Connections those_who(bool watch) const;
  void make_room();
  // The caller must hold the connection outside of connections_.
  void drop(const std::shared_ptr<WebConnection>& connection);

  WebOptions options_;
  WebHosts hosts_;
  WebContent content_;
  Connections connections_;  // the oldest first
  bool is_closed_ = false;
};

}  // namespace autoref::live
