#include "live/web/web_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/beast/websocket/rfc6455.hpp>
#include <charconv>
#include <string_view>

#include "io/words.hpp"

namespace autoref::live {
namespace {

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
        "AutoRef is not known as {} here. Open the page at this computer's address in numbers, "
        "or start AutoRef with --web-host and the name.\n",
        io::printable(lower_field(request, http::field::host)));
  }
  if (refusal == status::forbidden) return "Pages of other web sites must not read the game.\n";
  const boost::beast::string_view reason = http::obsolete_reason(refusal);
  return std::string(reason.data(), reason.size()) + "\n";
}

}  // namespace autoref::live
