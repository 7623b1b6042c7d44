// Which requests the web server answers, and how.
#pragma once

#include <utility>  // Boost 1.74 needs it before Asio

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/status.hpp>
#include <optional>
#include <string>

#include "live/web/web_address.hpp"

namespace autoref::live {

using WebRequest = boost::beast::http::request<boost::beast::http::empty_body>;

// ok: send the page. switching_protocols: accept the WebSocket. Otherwise the status of a refusal.
//
// Only GET is allowed, of /, of /game and, as a WebSocket, of /live. A web page from elsewhere must
// not read the game: if the request names an origin, it must be this server, and a request for
// another host than `hosts` is misdirected_request, which prevents DNS rebinding.
boost::beast::http::status answer_to(const WebRequest& request, const WebHosts& hosts);

// Says to a person why the request is refused, and what to do.
std::string refusal_text(const WebRequest& request, boost::beast::http::status refusal);

// The id of a game whose page is asked for, "b.robots=5-p0001-2" of /game?b.robots%3D5-p0001-2;
// nullopt if another page is.
std::optional<std::string> game_in(const WebRequest& request);

}  // namespace autoref::live
