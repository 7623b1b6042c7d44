#include "live/web/web_session.hpp"

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <optional>
#include <string>
#include <utility>

#include "live/web/watcher.hpp"
#include "live/web/web_request.hpp"

namespace autoref::live {
namespace {

namespace session_beast = boost::beast;
namespace session_http = session_beast::http;
using boost::asio::ip::tcp;
using Response = session_http::response<session_http::string_body>;

constexpr std::uint32_t kLongestHeader = 8192;

Response response_with(session_http::status status, std::string body, const char* type) {
  Response response(status, 11);
  response.set(session_http::field::content_type, type);
  response.set(session_http::field::cache_control, "no-store");
  response.set(session_http::field::x_frame_options, "DENY");
  response.set("X-Content-Type-Options", "nosniff");
  if (status == session_http::status::method_not_allowed)
    response.set(session_http::field::allow, "GET");
  response.keep_alive(false);
  response.body() = std::move(body);
  response.prepare_payload();
  return response;
}

Response refusal_of(const WebRequest& request, session_http::status status) {
  return response_with(status, refusal_text(request, status), "text/plain; charset=utf-8");
}

// Empty if the connection has ended already.
std::string computer_of(const tcp::socket& socket) {
  session_beast::error_code error;
  const tcp::endpoint endpoint = socket.remote_endpoint(error);
  return error ? std::string() : endpoint.address().to_string();
}

class WebSession final : public WebConnection, public std::enable_shared_from_this<WebSession> {
 public:
  WebSession(tcp::socket socket, std::shared_ptr<WebHub> hub)
      : WebConnection(computer_of(socket)), stream_(std::move(socket)), hub_(std::move(hub)) {
    parser_.header_limit(kLongestHeader);
  }

  void read() {
    stream_.expires_after(hub_->options().header_time);
    session_http::async_read_header(
        stream_, buffer_, parser_,
        [self = shared_from_this()](const session_beast::error_code& error, std::size_t) {
          if (self->hub_->is_closed()) return;
          // Another connection may have taken its place meanwhile.
          const bool is_over = error || !self->stream_.socket().is_open();
          is_over ? self->end() : self->answer();
        });
  }

  void close() override { stream_.close(); }
  WebState state() const override { return state_; }

 private:
  void answer() {
    state_ = WebState::kAnswered;
    const WebRequest& request = parser_.get();
    const session_http::status status = answer_to(request, hub_->hosts());
    if (status == session_http::status::ok) return write_page(game_in(request));
    if (status != session_http::status::switching_protocols) return refuse(status);
    if (!hub_->makes_room_for_watcher(computer()))
      return refuse(session_http::status::service_unavailable);
    hub_->remove(shared_from_this());
    start_watcher(std::move(stream_), computer(), request, hub_);
  }

  void write_page(const std::optional<std::string>& game) {
    std::optional<std::string> page = game ? hub_->game_page(*game) : hub_->page();
    if (!page) return refuse(session_http::status::not_found);
    write(response_with(session_http::status::ok, *std::move(page), "text/html; charset=utf-8"));
  }

  void refuse(session_http::status status) { write(refusal_of(parser_.get(), status)); }

  void write(Response response) {
    response_ = std::move(response);
    stream_.expires_after(hub_->options().write_time);
    session_http::async_write(
        stream_, *response_,
        [self = shared_from_this()](const session_beast::error_code&, std::size_t) {
          session_beast::error_code ignored;
          self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
          self->end();
        });
  }

  void end() {
    stream_.close();
    hub_->remove(shared_from_this());
  }

  session_beast::tcp_stream stream_;
  std::shared_ptr<WebHub> hub_;
  session_beast::flat_buffer buffer_{kLongestHeader};
  session_http::request_parser<session_http::empty_body> parser_;
  std::optional<Response> response_;
  WebState state_ = WebState::kSilent;
};

}  // namespace

void start_session(tcp::socket socket, const std::shared_ptr<WebHub>& hub) {
  const auto session = std::make_shared<WebSession>(std::move(socket), hub);
  hub->add(session);
  session->read();
}

}  // namespace autoref::live
