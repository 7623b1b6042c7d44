#include "runner/live/web_address.hpp"

#include <utility>  // Boost 1.74 needs it before Asio

#include <fmt/format.h>

#include <boost/asio/ip/address.hpp>
#include <optional>

#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"

namespace autoref::runner {
namespace {

constexpr int kHighestPort = 65'535;

using boost::asio::ip::make_address;

std::string_view without_brackets(std::string_view host) {
  const bool has_brackets = host.size() > 2 && host.front() == '[' && host.back() == ']';
  return has_brackets ? host.substr(1, host.size() - 2) : host;
}

bool is_ipv6(const std::string& host) { return host.find(':') != std::string::npos; }

std::string in_url(const std::string& host) {
  return is_ipv6(host) ? fmt::format("[{}]", host) : host;
}

}  // namespace

Address web_address(std::string_view text, const std::string& flag) {
  const std::size_t colon = text.rfind(':');
  const bool has_host = colon != std::string_view::npos;
  const std::string_view host = has_host ? without_brackets(text.substr(0, colon)) : kLoopback;
  const std::optional<int> port = whole_number_in(has_host ? text.substr(colon + 1) : text);
  boost::system::error_code error;
  make_address(std::string(host), error);
  if (error || !port || *port < 0 || *port > kHighestPort) {
    throw InputError({flag}, "",
                     fmt::format("expected a port or an address and a port, such as 127.0.0.1:8090 "
                                 "or 8090, found '{}'",
                                 text));
  }
  return {std::string(host), *port};
}

std::string url_of(const Address& address) {
  return fmt::format("http://{}:{}/", in_url(address.host), address.port);
}

std::vector<std::string> hosts_of(const Address& address) {
  if (!make_address(address.host).is_loopback()) return {};
  return {"localhost", "127.0.0.1", "[::1]", in_url(address.host)};
}

}  // namespace autoref::runner
