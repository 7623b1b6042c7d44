// One connection to the web server, until it is answered or has become a watcher.
#pragma once

#include "live/network/network_context.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "live/web/web_hub.hpp"

namespace autoref::live {

// Reads one request and answers it.
void start_session(boost::asio::ip::tcp::socket socket, const std::shared_ptr<WebHub>& hub);

}  // namespace autoref::live
