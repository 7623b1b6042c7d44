#include "live/web/web_request.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <charconv>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>  // needed before Asio in Boost 1.74

#include "io/errors.hpp"
#include "io/words.hpp"

namespace autoref::live {
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

// "localhost" for "localhost:8090", "[::1]" for "[::1]:8090".
std::string_view without_port(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  const std::size_t bracket = host.rfind(']');
  const bool has_port =
      colon != std::string_view::npos && (bracket == std::string_view::npos || bracket < colon);
  return has_port ? host.substr(0, colon) : host;
}

// Whether a request's host is an address, "127.0.0.1" or "[::1]".
bool is_numeric(std::string_view host) {
  boost::system::error_code error;
  const std::string_view inner = without_brackets(host);
  const auto address = make_address(std::string(inner), error);
  return !error && address.is_v6() == (inner.size() < host.size());
}

bool is_letter_of_name(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '.' ||
         letter == '-' || letter == '_';
}

// Returns the same text for all spellings of an address: without the interface's name, which
// browsers leave out, and as IPv4 if the IPv6 address contains one.
std::string text_of_address(const boost::asio::ip::address& address) {
  if (!address.is_v6()) return address.to_string();
  const boost::asio::ip::address_v6::bytes_type bytes = address.to_v6().to_bytes();
  const boost::asio::ip::address_v6 plain(bytes);
  if (!plain.is_v4_mapped()) return in_url(plain.to_string());
  return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, plain).to_string();
}

// Converts a name listed by the user to the form in which requests contain it.
std::string name_of_host(const std::string& text) {
  boost::system::error_code error;
  const auto address = make_address(std::string(without_brackets(text)), error);
  if (!error) return text_of_address(address);
  std::string name = io::lower_case(text);
  if (!name.empty() && std::all_of(name.begin(), name.end(), is_letter_of_name)) return name;
  throw io::InputError({"--web-host"}, "",
                       fmt::format("expected the name of a computer without port, such as "
                                   "laptop.local, found '{}'",
                                   text));
}

void add_names(std::vector<std::string>& names, std::initializer_list<const char*> further) {
  names.insert(names.end(), further.begin(), further.end());
}

namespace http = boost::beast::http;
using http::status;

std::string lower_field(const WebRequest& request, http::field field) {
  const boost::beast::string_view value = request[field];
  return io::lower_case({value.data(), value.size()});
}

bool is_own(std::string_view origin, std::string_view host) {
  for (const std::string_view scheme : {"http://", "https://"})
    if (origin.starts_with(scheme) && origin.substr(scheme.size()) == host) return true;
  return false;
}

boost::beast::string_view path_of(const WebRequest& request) {
  const boost::beast::string_view target = request.target();
  return target.substr(0, target.find('?'));
}

// "a=b" for "a%3Db". Invalid codes stay unchanged.
std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    const char* const digits = text.data() + i + 1;
    const bool is_code = text[i] == '%' && i + 2 < text.size() &&
                         std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    decoded += is_code ? static_cast<char>(code) : text[i];
    if (is_code) i += 2;
  }
  return decoded;
}

}  // namespace

Address web_address(std::string_view text, const std::string& flag) {
  const std::size_t colon = text.rfind(':');
  const bool has_host = colon != std::string_view::npos;
  const std::string_view host = has_host ? without_brackets(text.substr(0, colon)) : kLoopback;
  const std::optional<int> port = io::whole_number_in(has_host ? text.substr(colon + 1) : text);
  boost::system::error_code error;
  make_address(std::string(host), error);
  if (error || !port || *port < 0 || *port > kHighestPort) {
    throw io::InputError(
        {flag}, "",
        fmt::format("expected a port or an address and a port, such as 127.0.0.1:8090 "
                    "or 8090, found '{}'",
                    text));
  }
  return {std::string(host), *port};
}

std::string url_of(const Address& address) {
  return fmt::format("http://{}:{}/", in_url(address.host), address.port);
}

bool WebHosts::has(std::string_view host) const {
  const std::string_view name = without_port(host);
  const bool is_address = is_numeric(name);
  if (is_address && has_every_address) return true;
  const std::string text = is_address
                               ? text_of_address(make_address(std::string(without_brackets(name))))
                               : std::string(name);
  return std::find(names.begin(), names.end(), text) != names.end();
}

WebHosts hosts_of(const Address& address, const std::vector<std::string>& further) {
  const boost::asio::ip::address listening = make_address(address.host);
  WebHosts hosts{{text_of_address(listening)}, listening.is_unspecified()};
  if (listening.is_loopback()) add_names(hosts.names, {"localhost", "127.0.0.1", "[::1]"});
  if (listening.is_unspecified()) add_names(hosts.names, {"localhost"});
  for (const std::string& name : further) hosts.names.push_back(name_of_host(name));
  return hosts;
}

std::optional<std::string> game_in(const WebRequest& request) {
  const boost::beast::string_view path = path_of(request);
  if (path != "/game") return std::nullopt;
  const boost::beast::string_view target = request.target();
  const boost::beast::string_view query = target.substr(std::min(path.size() + 1, target.size()));
  return percent_decoded({query.data(), query.size()});
}

status answer_to(const WebRequest& request, const WebHosts& hosts) {
  const std::string host = lower_field(request, http::field::host);
  if (host.empty()) return status::bad_request;
  if (!hosts.has(host)) return status::misdirected_request;
  const bool has_origin = request.find(http::field::origin) != request.end();
  if (has_origin && !is_own(lower_field(request, http::field::origin), host))
    return status::forbidden;
  if (request.method() != http::verb::get) return status::method_not_allowed;
  const boost::beast::string_view path = path_of(request);
  if (path == "/" || path == "/game") return status::ok;
  if (path != "/live") return status::not_found;
  return boost::beast::websocket::is_upgrade(request) ? status::switching_protocols
                                                      : status::upgrade_required;
}

std::string refusal_text(const WebRequest& request, status refusal) {
  if (refusal == status::misdirected_request) {
    return fmt::format(
        "AutoRef does not answer to the name {}. Open the page at this computer's numeric address, "
        "or start AutoRef with --web-host and this name.\n",
        io::printable(lower_field(request, http::field::host)));
  }
  if (refusal == status::forbidden) return "Pages of other web sites cannot read the game.\n";
  const boost::beast::string_view reason = http::obsolete_reason(refusal);
  return std::string(reason.data(), reason.size()) + "\n";
}

}  // namespace autoref::live
