// The web server's address, the requests that it answers, and its answers.
#pragma once

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/status.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>  // needed before Asio in Boost 1.74
#include <vector>

#include "live/network/network.hpp"

namespace autoref::live {

// Reads "127.0.0.1:8090", "[::1]:8090" or "8090", where a port alone means the loopback address.
// Port 0 means any free port. Throws InputError naming `flag`.
Address web_address(std::string_view text, const std::string& flag);

// "http://127.0.0.1:8090/"
std::string url_of(const Address& address);

// The names by which requests can address a server.
struct WebHosts {
  std::vector<std::string> names;  // in lower case and without port, IPv6 addresses in brackets
  bool has_every_address = false;  // also every numeric address

  // `host` is a request's host in lower case; its port does not matter.
  bool has(std::string_view host) const;
};

// The names of a server: its address and the `further` names (--web-host). A server on the loopback
// or on all addresses of this computer also has the name localhost. A server on all addresses
// accepts every numeric address. For DNS rebinding, a web page needs a name for this server, so
// numeric addresses need not be checked. Throws InputError naming --web-host.
WebHosts hosts_of(const Address& address, const std::vector<std::string>& further = {});

using WebRequest = boost::beast::http::request<boost::beast::http::empty_body>;

// The status of the answer. ok: send the page. switching_protocols: accept the WebSocket. Any other
// status is a refusal.
//
// Only GET is allowed, for /, /game and (as a WebSocket) /live. A web page from elsewhere must not
// read the game: if the request names an origin, it must be this server. A request for a host not
// in `hosts` gets misdirected_request, which prevents DNS rebinding.
boost::beast::http::status answer_to(const WebRequest& request, const WebHosts& hosts);

// Explains in plain words why the request is refused and what to do.
std::string refusal_text(const WebRequest& request, boost::beast::http::status refusal);

// The id of the game whose page is requested: "b.robots=5-p0001-2" for /game?b.robots%3D5-p0001-2.
// nullopt if another page is requested.
std::optional<std::string> game_in(const WebRequest& request);

}  // namespace autoref::live
