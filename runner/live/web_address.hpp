// Where a web server listens.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runner/live/network.hpp"

namespace autoref::runner {

// Reads "127.0.0.1:8090", "[::1]:8090" or "8090", which means the loopback; port 0 means any free
// one. Throws InputError naming `flag`.
Address web_address(std::string_view text, const std::string& flag);

// "http://127.0.0.1:8090/"
std::string url_of(const Address& address);

// The names by which requests may address a server on this address (web_request.hpp); empty: any.
std::vector<std::string> hosts_of(const Address& address);

}  // namespace autoref::runner
