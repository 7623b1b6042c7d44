// Where a web server listens.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "live/network/network.hpp"

namespace autoref::live {

// Reads "127.0.0.1:8090", "[::1]:8090" or "8090", which means the loopback; port 0 means any free
// one. Throws InputError naming `flag`.
Address web_address(std::string_view text, const std::string& flag);

// "http://127.0.0.1:8090/"
std::string url_of(const Address& address);

// The names by which requests may address a server.
struct WebHosts {
  std::vector<std::string> names;  // in lower case and without port, IPv6 addresses in brackets
  bool has_every_address = false;  // also every address in numbers

  // `host` is that of a request, in lower case; its port does not matter.
  bool has(std::string_view host) const;
};

// The address itself, and `further` names (--web-host). A server on the loopback, or on all
// addresses of this computer, is also localhost; one on all addresses takes every address in
// numbers. A web page can only pretend to be this server (DNS rebinding) by a name, so that
// addresses need not be known. Throws InputError naming --web-host.
WebHosts hosts_of(const Address& address, const std::vector<std::string>& further = {});

}  // namespace autoref::live
