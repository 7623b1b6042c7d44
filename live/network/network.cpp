#include "live/network/network.hpp"

#include "live/network/network_context.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <array>
#include <atomic>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <future>

#include "io/errors.hpp"

namespace autoref::live {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;
using boost::system::error_code;

// Number of hops of multicast packets: only the interface's own network.
constexpr int kHops = 1;
constexpr int kMostAtOnce = 256;               // datagrams read before other work of the thread
constexpr int kReceiveBuffer_bytes = 1 << 20;  // large enough for bursts

asio::ip::address_v4 address_of(const std::string& host, const std::string& flag) {
  error_code error;
  asio::ip::address_v4 address = asio::ip::make_address_v4(host, error);
  if (error)
    throw io::InputError({flag}, "",
                         fmt::format("'{}' is not an IPv4 address such as 127.0.0.1", host));
  return address;
}

[[noreturn]] void refuse(const std::string& flag, const std::string& what,
                         const error_code& error) {
  throw io::InputError({flag}, "", fmt::format("{}: {}", what, error.message()));
}

}  // namespace

std::optional<std::string> broadcast_address(const std::string& interface) {
  if (interface == kLoopback) return "127.255.255.255";
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) return std::nullopt;
  std::optional<std::string> found;
  const auto text = [](const sockaddr* address) {
    std::array<char, INET_ADDRSTRLEN> buffer{};
    const auto* ipv4 = reinterpret_cast<const sockaddr_in*>(address);
    return std::string(::inet_ntop(AF_INET, &ipv4->sin_addr, buffer.data(), buffer.size()));
  };
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    const bool is_ipv4 = one->ifa_addr != nullptr && one->ifa_addr->sa_family == AF_INET;
    if (is_ipv4 && (one->ifa_flags & IFF_BROADCAST) != 0 && one->ifa_broadaddr != nullptr &&
        text(one->ifa_addr) == interface)
      found = text(one->ifa_broadaddr);
  }
  ::freeifaddrs(all);
  return found;
}

void open_for_group(udp::socket& socket, const DatagramReceiver::Place& place,
                    int receive_buffer_bytes) {
  const asio::ip::address_v4 on = address_of(place.interface, "--interface");
  const bool is_group = !place.group.empty();
  const auto port = static_cast<unsigned short>(place.port);
  error_code error;
  socket.open(udp::v4());
  if (is_group) socket.set_option(udp::socket::reuse_address(true));
  socket.set_option(udp::socket::receive_buffer_size(receive_buffer_bytes), error);
  const asio::ip::address_v4 bound = is_group ? address_of(place.group, place.flag) : on;
  socket.bind({bound, port}, error);
  if (error)
    refuse(place.flag, fmt::format("cannot listen at {}:{}", bound.to_string(), port), error);
  if (!is_group || !bound.is_multicast()) return;
  socket.set_option(asio::ip::multicast::join_group(bound, on), error);
  if (error) refuse("--interface", fmt::format("cannot join {}", place.group), error);
}

NetworkThread::NetworkThread() : context_(std::make_unique<Context>()) {}
NetworkThread::~NetworkThread() = default;

class DatagramSender::Impl {
 public:
  Impl(const std::string& interface, const Address& to)
      : socket_(io_, udp::v4()),
        to_(address_of(to.host, "--unicast"), static_cast<unsigned short>(to.port)) {
    const asio::ip::address_v4 on = address_of(interface, "--interface");
    error_code error;
    socket_.non_blocking(true);
    socket_.set_option(asio::ip::multicast::outbound_interface(on), error);
    if (error) refuse("--interface", fmt::format("cannot send on {}", interface), error);
    socket_.set_option(asio::ip::multicast::hops(kHops));
    socket_.set_option(asio::ip::multicast::enable_loopback(true));
    socket_.set_option(asio::socket_base::broadcast(true));
  }

  void send(std::string_view bytes) {
    error_code error;
    socket_.send_to(asio::buffer(bytes.data(), bytes.size()), to_, 0, error);
    if (error) ++dropped_;
  }

  std::int64_t dropped() const { return dropped_; }

 private:
  asio::io_context io_;
  udp::socket socket_;
  udp::endpoint to_;
  std::int64_t dropped_ = 0;
};

DatagramSender::DatagramSender(const std::string& interface, const Address& to)
    : impl_(std::make_unique<Impl>(interface, to)) {}
DatagramSender::~DatagramSender() = default;
DatagramSender::DatagramSender(DatagramSender&&) noexcept = default;
DatagramSender& DatagramSender::operator=(DatagramSender&&) noexcept = default;
void DatagramSender::send(std::string_view bytes) { impl_->send(bytes); }
std::int64_t DatagramSender::dropped() const { return impl_->dropped(); }

// The asynchronous wait keeps this alive, so it can outlive its owner.
class DatagramReceiver::Impl : public std::enable_shared_from_this<DatagramReceiver::Impl> {
 public:
  Impl(NetworkThread& thread, const Place& place, Handler handler)
      : socket_(thread.context().io), handler_(std::move(handler)) {
    open_for_group(socket_, place, kReceiveBuffer_bytes);
    socket_.non_blocking(true);
    port_ = socket_.local_endpoint().port();
  }

  void start() {
    socket_.async_wait(udp::socket::wait_read,
                       [self = shared_from_this()](const error_code& error) {
                         if (error || !self->socket_.is_open()) return;
                         self->read_all();
                         self->start();
                       });
  }

  void send(std::string bytes, const Address& to) {
    asio::post(socket_.get_executor(), [self = shared_from_this(), bytes = std::move(bytes), to] {
      error_code error;
      const udp::endpoint endpoint(asio::ip::make_address_v4(to.host, error),
                                   static_cast<unsigned short>(to.port));
      if (!error) self->socket_.send_to(asio::buffer(bytes), endpoint, 0, error);
    });
  }

  // Returns once the handler is no longer called.
  void stop() {
    std::promise<void> stopped;
    asio::post(socket_.get_executor(), [&] {
      error_code error;
      socket_.close(error);
      stopped.set_value();
    });
    stopped.get_future().wait();
  }

  int port() const { return port_; }
  std::int64_t oversized() const { return oversized_; }

 private:
  void read_all() {
    for (int i = 0;; ++i) {
      if (i == kMostAtOnce) return read_more();
      error_code error;
      const std::size_t size = socket_.receive_from(asio::buffer(buffer_), from_, 0, error);
      if (error == asio::error::would_block) return;
      if (error) continue;  // for example, because a port refused a reply
      if (size == buffer_.size()) {
        ++oversized_;
        continue;
      }
      const Address from{from_.address().to_string(), from_.port()};
      const auto reply = handler_(std::string_view(buffer_.data(), size), from);
      if (reply) socket_.send_to(asio::buffer(*reply), from_, 0, error);
    }
  }

  // Datagrams that are left unread do not wake the thread again.
  void read_more() {
    asio::post(socket_.get_executor(), [self = shared_from_this()] {
      if (self->socket_.is_open()) self->read_all();
    });
  }

  udp::socket socket_;
  udp::endpoint from_;
  Handler handler_;
  std::array<char, kLongestDatagram + 1> buffer_{};
  int port_ = 0;
  std::atomic<std::int64_t> oversized_{0};
};

DatagramReceiver::DatagramReceiver(NetworkThread& thread, const Place& place, Handler handler)
    : impl_(std::make_shared<Impl>(thread, place, std::move(handler))) {
  impl_->start();
}
DatagramReceiver::~DatagramReceiver() {
  if (impl_) impl_->stop();
}
DatagramReceiver::DatagramReceiver(DatagramReceiver&&) noexcept = default;
DatagramReceiver& DatagramReceiver::operator=(DatagramReceiver&&) noexcept = default;
void DatagramReceiver::send(std::string bytes, const Address& to) {
  impl_->send(std::move(bytes), to);
}
int DatagramReceiver::port() const { return impl_->port(); }
std::int64_t DatagramReceiver::oversized() const { return impl_->oversized(); }

}  // namespace autoref::live
