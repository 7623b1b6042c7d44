#include "live/web/web_server.hpp"

#include "live/network/network_context.hpp"

#include <fmt/format.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <future>
#include <mutex>
#include <vector>

#include "io/errors.hpp"
#include "live/web/web_address.hpp"
#include "live/web/web_hub.hpp"
#include "live/web/web_session.hpp"

namespace autoref::live {
namespace {

namespace web_asio = boost::asio;
using web_asio::ip::tcp;

constexpr std::size_t kMostHandedOver = 1024;          // messages that wait for the thread
constexpr std::chrono::milliseconds kAfterError{100};  // such as too many open files

}  // namespace

// Kept alive by its asynchronous operations, so that they can end after its owner.
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

  // Returns once nothing of the owner is used any more.
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

  // Watchers who would miss more than frames are disconnected; they connect again.
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
  std::size_t handed_over_bytes_ = 0;  // with those left out
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
