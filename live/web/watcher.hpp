// A watcher: a WebSocket that gets all messages.
#pragma once

#include "live/network/network_context.hpp"

#include <boost/beast/core/tcp_stream.hpp>
#include <memory>

#include "live/web/web_hub.hpp"
#include "live/web/web_request.hpp"

namespace autoref::live {

// Answers the request for a WebSocket, then sends the backlog and all further messages.
void start_watcher(boost::beast::tcp_stream stream, const std::string& computer,
                   const WebRequest& request, const std::shared_ptr<WebHub>& hub);

}  // namespace autoref::live
