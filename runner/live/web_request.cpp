#include "runner/live/web_request.hpp"

#include <algorithm>
#include <boost/beast/websocket/rfc6455.hpp>
#include <charconv>
#include <string_view>

namespace autoref::runner {
namespace {

namespace http = boost::beast::http;
using http::status;

std::string lower_field(const WebRequest& request, http::field field) {
  const boost::beast::string_view value = request[field];
  std::string text(value.data(), value.size());
  std::transform(text.begin(), text.end(), text.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return text;
}

// "localhost" of "localhost:8090", "[::1]" of "[::1]:8090".
std::string_view without_port(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  const std::size_t bracket = host.rfind(']');
  const bool has_port =
      colon != std::string_view::npos && (bracket == std::string_view::npos || bracket < colon);
  return has_port ? host.substr(0, colon) : host;
}

bool is_known(std::string_view host, const std::vector<std::string>& hosts) {
  return hosts.empty() || std::find(hosts.begin(), hosts.end(), without_port(host)) != hosts.end();
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

// "a=b" of "a%3Db". Wrong codes are kept as they are.
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

std::optional<std::string> game_in(const WebRequest& request) {
  const boost::beast::string_view path = path_of(request);
  if (path != "/game") return std::nullopt;
  const boost::beast::string_view target = request.target();
  const boost::beast::string_view query = target.substr(std::min(path.size() + 1, target.size()));
  return percent_decoded({query.data(), query.size()});
}

status answer_to(const WebRequest& request, const std::vector<std::string>& hosts) {
  const std::string host = lower_field(request, http::field::host);
  if (host.empty()) return status::bad_request;
  if (!is_known(host, hosts)) return status::forbidden;
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

}  // namespace autoref::runner
