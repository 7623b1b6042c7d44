// A watcher: a WebSocket that gets all messages, and the queue of messages waiting for it.
#pragma once

#include <boost/beast/core/tcp_stream.hpp>
#include <cstddef>
#include <deque>
#include <memory>

#include "live/network/network_context.hpp"
#include "live/web/web_hub.hpp"
#include "live/web/web_message.hpp"
#include "live/web/web_request.hpp"

namespace autoref::live {

// Messages waiting for a watcher. Only the newest frames wait; other messages are kept up to limits
// on their number and their bytes (kMostWaiting_bytes, including the frames). The backlog is shared
// with the server, which limits its size.
class WatcherQueue {
 public:
  static constexpr std::size_t kMostFrames = 3;
  static constexpr std::size_t kMostOthers = 2000;

  // Puts the backlog before all other messages.
  void begin_with(const WebBacklog& backlog);

  // Returns false if too many messages that cannot be left out are waiting. Ignores messages that
  // the backlog contains.
  bool push(const WebMessage& message);

  // The next message; null if none is waiting.
  WebText pop();

  std::int64_t left_out() const { return left_out_; }  // number of frames left out

 private:
  void leave_out_oldest_frame();

  std::deque<WebText> backlog_;
  std::int64_t last_number_ = 0;  // number of the last message in the backlog
  std::deque<WebMessage> waiting_;
  std::size_t frames_ = 0;  // number of frames among the waiting messages
  std::size_t bytes_ = 0;   // total size of all waiting messages
  std::int64_t left_out_ = 0;
};

// Answers the request for a WebSocket, then sends the backlog and all further messages.
void start_watcher(boost::beast::tcp_stream stream, const std::string& computer,
                   const WebRequest& request, const std::shared_ptr<WebHub>& hub);

}  // namespace autoref::live
