#include "live/network/stream_server.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/errors.hpp"
#include "league/team/delimited.hpp"
#include "league/team/team_fault.hpp"
#include "live/network/network.hpp"
#include "live/network/network_context.hpp"

namespace autoref::live {
namespace {

using boost::asio::ip::tcp;
using boost::system::error_code;

// Pause after failing to accept a connection.
constexpr std::chrono::milliseconds kAcceptPause{100};

tcp::endpoint endpoint_of(const DatagramReceiver::Place& place) {
  error_code error;
  const auto address = boost::asio::ip::make_address_v4(place.interface, error);
  if (error)
    throw io::InputError(
        {"--interface"}, "",
        fmt::format("'{}' is not an IPv4 address such as 127.0.0.1", place.interface));
  return {address, static_cast<unsigned short>(place.port)};
}

bool is_equal(const Address& one, const Address& other) {
  return one.port == other.port && one.host == other.host;
}

}  // namespace

// Reads messages and writes responses. All functions are called in the network's thread.
class StreamConnection : public std::enable_shared_from_this<StreamConnection> {
 public:
  enum class End { kClosed, kInvalid, kUnread };
  using Clock = std::chrono::steady_clock;

  // Returns the response; nullopt if there is none yet.
  using OnMessage = DatagramReceiver::Handler;
  // Called once, just before the connection is closed, except if close() closes the connection.
  using OnEnd = std::function<void(const StreamConnection& connection, End why)>;

  StreamConnection(boost::asio::ip::tcp::socket socket, OnMessage on_message, OnEnd on_end);

  void start() { read(); }
  void send(std::string_view message);
  void close();

  const Address& peer() const { return peer_; }
  // When the last message arrived or the connection was made.
  Clock::time_point last_heard() const { return last_heard_; }

 private:
  static constexpr std::size_t kChunk = 1 << 14;

  void read();
  void take_messages();
  void write();
  void end(End why);

  boost::asio::ip::tcp::socket socket_;
  OnMessage on_message_;
  OnEnd on_end_;
  Address peer_;
  Clock::time_point last_heard_ = Clock::now();
  std::array<char, kChunk> chunk_{};
  std::string received_;  // bytes received, not yet a complete message
  std::string waiting_;   // bytes to be written
  std::string written_;   // bytes being written
  bool is_writing_ = false;
  bool is_open_ = true;
};

StreamConnection::StreamConnection(tcp::socket socket, OnMessage on_message, OnEnd on_end)
    : socket_(std::move(socket)), on_message_(std::move(on_message)), on_end_(std::move(on_end)) {
  error_code error;
  socket_.set_option(tcp::no_delay(true), error);
  socket_.set_option(boost::asio::socket_base::keep_alive(true), error);
  const tcp::endpoint peer = socket_.remote_endpoint(error);
  if (!error) peer_ = {peer.address().to_string(), peer.port()};
}

void StreamConnection::read() {
  socket_.async_read_some(boost::asio::buffer(chunk_),
                          [self = shared_from_this()](const error_code& error, std::size_t size) {
                            if (!self->is_open_) return;
                            if (error) return self->end(End::kClosed);
                            self->received_.append(self->chunk_.data(), size);
                            self->take_messages();
                            if (self->is_open_) self->read();
                          });
}

// Less than one message remains unread, so memory is bounded.
void StreamConnection::take_messages() {
  std::string_view rest = received_;
  try {
    while (const std::optional<league::MessageExtent> extent = league::find_delimited(rest)) {
      last_heard_ = Clock::now();
      const auto response = on_message_(rest.substr(extent->begin, extent->size), peer_);
      rest.remove_prefix(extent->end);
      if (response) send(*response);
      if (!is_open_) return;
    }
  } catch (const league::TeamFault&) {
    return end(End::kInvalid);
  }
  received_.erase(0, received_.size() - rest.size());
}

void StreamConnection::send(std::string_view message) {
  if (!is_open_) return;
  if (waiting_.size() + written_.size() + message.size() > kMostUnread) return end(End::kUnread);
  league::append_delimited(message, waiting_);
  if (!is_writing_) write();
}

void StreamConnection::write() {
  written_.swap(waiting_);
  is_writing_ = true;
  boost::asio::async_write(socket_, boost::asio::buffer(written_),
                           [self = shared_from_this()](const error_code& error, std::size_t) {
                             self->is_writing_ = false;
                             self->written_.clear();
                             if (!self->is_open_) return;
                             if (error) return self->end(End::kClosed);
                             if (!self->waiting_.empty()) self->write();
                           });
}

void StreamConnection::end(End why) {
  if (!is_open_) return;
  is_open_ = false;
  const auto self = shared_from_this();
  on_end_(*this, why);
  close();
}

void StreamConnection::close() {
  is_open_ = false;
  error_code error;
  socket_.close(error);
}

// The asynchronous operations keep this alive, so they can outlive its owner.
class StreamServer::Impl : public std::enable_shared_from_this<StreamServer::Impl> {
 public:
  Impl(NetworkThread& thread, const DatagramReceiver::Place& place, Handler handler,
       std::chrono::milliseconds silent)
      : acceptor_(thread.context().io),
        pause_(thread.context().io),
        handler_(std::move(handler)),
        silent_(silent) {
    const tcp::endpoint endpoint = endpoint_of(place);
    error_code error;
    acceptor_.open(tcp::v4());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(static_cast<int>(kMostConnections), error);
    if (error)
      throw io::InputError({place.flag}, "",
                           fmt::format("cannot listen at {}:{} (TCP): {}", place.interface,
                                       place.port, error.message()));
    port_ = acceptor_.local_endpoint().port();
  }

  void start() {
    acceptor_.async_accept(
        [self = shared_from_this()](const error_code& error, tcp::socket socket) {
          if (!self->acceptor_.is_open()) return;
          if (error) return self->start_later();
          self->add_connection(std::move(socket));
          self->start();
        });
  }

  void send(std::string message, const Address& to) {
    boost::asio::post(acceptor_.get_executor(),
                      [self = shared_from_this(), message = std::move(message), to] {
                        for (const Connection& one : self->connections_) {
                          if (is_equal(one->peer(), to)) return one->send(message);
                        }
                      });
  }

  // Returns once the handler is no longer called.
  void stop() {
    std::promise<void> stopped;
    boost::asio::post(acceptor_.get_executor(), [&] {
      error_code error;
      acceptor_.close(error);
      pause_.cancel();
      for (const Connection& one : connections_) one->close();
      connections_.clear();
      stopped.set_value();
    });
    stopped.get_future().wait();
  }

  int port() const { return port_; }

  StreamTroubles troubles() const {
    const std::lock_guard lock(mutex_);
    return troubles_;
  }

 private:
  using Connection = std::shared_ptr<StreamConnection>;

  // Called, for example, when the process has too many open files.
  void start_later() {
    pause_.expires_after(kAcceptPause);
    pause_.async_wait([self = shared_from_this()](const error_code&) {
      if (self->acceptor_.is_open()) self->start();
    });
  }

  void add_connection(tcp::socket socket) {
    if (connections_.size() == kMostConnections && !make_room()) return count(troubles_.refused);
    const auto connection = std::make_shared<StreamConnection>(
        std::move(socket),
        [self = weak_from_this()](std::string_view message, const Address& from) {
          const auto server = self.lock();
          return server ? server->handler_(message, from) : std::nullopt;
        },
        [self = weak_from_this()](const StreamConnection& ended, StreamConnection::End why) {
          if (const auto server = self.lock()) server->forget(ended, why);
        });
    connections_.push_back(connection);
    connection->start();
  }

  bool make_room() {
    const auto oldest = std::min_element(
        connections_.begin(), connections_.end(),
        [](const Connection& a, const Connection& b) { return a->last_heard() < b->last_heard(); });
    if (StreamConnection::Clock::now() - (*oldest)->last_heard() < silent_) return false;
    (*oldest)->close();
    connections_.erase(oldest);
    return true;
  }

  void forget(const StreamConnection& ended, StreamConnection::End why) {
    std::erase_if(connections_, [&](const Connection& one) { return one.get() == &ended; });
    if (why == StreamConnection::End::kInvalid) count(troubles_.invalid);
    if (why == StreamConnection::End::kUnread) count(troubles_.unread);
  }

  void count(std::int64_t& trouble) {
    const std::lock_guard lock(mutex_);
    ++trouble;
  }

  tcp::acceptor acceptor_;
  boost::asio::steady_timer pause_;
  Handler handler_;
  std::chrono::milliseconds silent_;
  std::vector<Connection> connections_;
  int port_ = 0;
  mutable std::mutex mutex_;
  StreamTroubles troubles_;
};

StreamServer::StreamServer(NetworkThread& thread, const DatagramReceiver::Place& place,
                           Handler handler, std::chrono::milliseconds silent)
    : impl_(std::make_shared<Impl>(thread, place, std::move(handler), silent)) {
  impl_->start();
}
StreamServer::~StreamServer() { impl_->stop(); }
void StreamServer::send(std::string message, const Address& to) {
  impl_->send(std::move(message), to);
}
int StreamServer::port() const { return impl_->port(); }
StreamTroubles StreamServer::troubles() const { return impl_->troubles(); }

}  // namespace autoref::live
