#include "live/web/web_server.hpp"

#include <fmt/format.h>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/errors.hpp"
#include "live/network/network_context.hpp"
#include "live/web/watcher.hpp"
#include "live/web/web_hub.hpp"
#include "live/web/web_request.hpp"

namespace autoref::live {
namespace {

// Reads one request and answers it.
void start_session(boost::asio::ip::tcp::socket socket, const std::shared_ptr<WebHub>& hub);

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

// Empty if the connection has already ended.
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

void start_session(tcp::socket socket, const std::shared_ptr<WebHub>& hub) {
  const auto session = std::make_shared<WebSession>(std::move(socket), hub);
  hub->add(session);
  session->read();
}

namespace web_asio = boost::asio;
using web_asio::ip::tcp;

constexpr std::size_t kMostHandedOver = 1024;  // maximum number of messages waiting for the thread
constexpr std::chrono::milliseconds kAfterError{
    100};  // pause, for example if too many files are open

}  // namespace

// Its asynchronous operations keep this alive, so they can outlive its owner.
class WebServer::Impl : public std::enable_shared_from_this<WebServer::Impl> {
 public:
  Impl(NetworkThread& thread, const WebOptions& options, WebContent content)
      : address_(options.address),
        hub_(std::make_shared<WebHub>(options, hosts_of(options.address, options.further_hosts),
                                      std::move(content))),
        acceptor_(thread.context().io),
        pause_(thread.context().io) {
    listen();
    address_.port = acceptor_.local_endpoint().port();
  }

  const Address& address() const { return address_; }

  void accept() {
    acceptor_.async_accept(
        [self = shared_from_this()](const boost::system::error_code& error, tcp::socket socket) {
          if (!self->acceptor_.is_open()) return;
          if (error) return self->accept_later();
          if (!self->hub_->is_closed()) start_session(std::move(socket), self->hub_);
          self->accept();
        });
  }

  void send(WebMessage message) {
    const std::lock_guard lock(mutex_);
    handed_over_bytes_ += message.text->size();
    if (handed_over_.size() < kMostHandedOver && handed_over_bytes_ <= kMostWaiting_bytes) {
      handed_over_.push_back(std::move(message));
    } else {
      is_incomplete_ = true;
    }
    if (is_posted_) return;
    is_posted_ = true;
    web_asio::post(acceptor_.get_executor(), [self = shared_from_this()] { self->send_all(); });
  }

  // Returns once nothing that belongs to the owner is in use.
  void stop() {
    std::promise<void> stopped;
    web_asio::post(acceptor_.get_executor(), [&] {
      boost::system::error_code error;
      acceptor_.close(error);
      pause_.cancel();
      hub_->close();
      stopped.set_value();
    });
    stopped.get_future().wait();
  }

 private:
  void listen() {
    const tcp::endpoint endpoint(web_asio::ip::make_address(address_.host),
                                 static_cast<unsigned short>(address_.port));
    boost::system::error_code error;
    acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(tcp::acceptor::max_listen_connections, error);
    if (!error) return;
    throw io::InputError(
        {"--web"}, "",
        fmt::format("cannot listen at {}:{}: {}", address_.host, address_.port, error.message()));
  }

  void accept_later() {
    pause_.expires_after(kAfterError);
    pause_.async_wait([self = shared_from_this()](const boost::system::error_code& error) {
      if (!error) self->accept();
    });
  }

  // Watchers that would miss messages other than frames are disconnected; they reconnect.
  void send_all() {
    std::vector<WebMessage> messages;
    bool is_incomplete = false;
    {
      const std::lock_guard lock(mutex_);
      messages.swap(handed_over_);
      handed_over_bytes_ = 0;
      std::swap(is_incomplete, is_incomplete_);
      is_posted_ = false;
    }
    if (is_incomplete) return hub_->close_watchers();
    for (const WebMessage& message : messages) hub_->send(message);
  }

  Address address_;
  std::shared_ptr<WebHub> hub_;
  tcp::acceptor acceptor_;
  web_asio::steady_timer pause_;
  std::mutex mutex_;
  std::vector<WebMessage> handed_over_;
  std::size_t handed_over_bytes_ = 0;  // including messages that were left out
  bool is_posted_ = false;
  bool is_incomplete_ = false;
};

WebServer::WebServer(NetworkThread& thread, const WebOptions& options, WebContent content)
    : impl_(std::make_shared<Impl>(thread, options, std::move(content))) {
  impl_->accept();
}
WebServer::~WebServer() { impl_->stop(); }
void WebServer::send(WebMessage message) { impl_->send(std::move(message)); }
std::string WebServer::url() const { return url_of(impl_->address()); }
int WebServer::port() const { return impl_->address().port; }

}  // namespace autoref::live
