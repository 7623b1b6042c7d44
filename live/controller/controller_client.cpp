#include "live/controller/controller_client.hpp"

#include "live/network/network_context.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <future>
#include <mutex>
#include <thread>

namespace autoref::live {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds kTick{20};
constexpr double kRetry_s = 1;
constexpr double kLongestConnect_s = 3;
constexpr std::chrono::seconds kLastEvents{1};

double steady_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

// All functions but status() run in the network's thread.
class ControllerClient::Impl : public std::enable_shared_from_this<ControllerClient::Impl> {
 public:
  Impl(NetworkThread& thread, const Address& controller, std::string identifier)
      : io_(thread.context().io),
        socket_(io_),
        timer_(io_),
        controller_(controller),
        session_(std::move(identifier)) {}

  asio::io_context& io() { return io_; }

  void tick() {
    if (is_over_) return;
    const double now_s = steady_s();
    if (phase_ == Phase::kClosed && now_s >= retry_s_ && !controller_.host.empty()) connect(now_s);
    if (phase_ == Phase::kConnecting && now_s - connecting_s_ > kLongestConnect_s)
      close("no answer to the connection request");
    if (phase_ == Phase::kOpen) write(now_s);
    publish_status();
    timer_.expires_after(kTick);
    timer_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error) self->tick();
    });
  }

  void set_host(const std::string& host) {
    if (host == controller_.host) return;
    controller_.host = host;
    close("");
    retry_s_ = 0;
  }

  void report(const GameEvent& event) {
    session_.report(event, steady_s());
    if (phase_ == Phase::kOpen) write(steady_s());
    publish_status();
  }

  void stop() {
    is_over_ = true;
    timer_.cancel();
    close("");
  }

  ControllerStatus status() const {
    const std::lock_guard lock(mutex_);
    return status_;
  }

 private:
  enum class Phase : std::uint8_t { kClosed, kConnecting, kOpen };

  void connect(double now_s) {
    error_code error;
    const auto host = asio::ip::make_address_v4(controller_.host, error);
    if (error) return close(fmt::format("'{}' is not an IPv4 address", controller_.host));
    phase_ = Phase::kConnecting;
    connecting_s_ = now_s;
    const std::int64_t connection = connection_;
    socket_.async_connect({host, static_cast<unsigned short>(controller_.port)},
                          [self = shared_from_this(), connection](const error_code& failure) {
                            if (connection != self->connection_) return;
                            if (failure) return self->close(failure.message());
                            self->phase_ = Phase::kOpen;
                            self->session_.begin(steady_s());
                            self->read();
                          });
  }

  void read() {
    const std::int64_t connection = connection_;
    socket_.async_read_some(asio::buffer(input_), [self = shared_from_this(), connection](
                                                      const error_code& error, std::size_t size) {
      if (connection != self->connection_) return;
      if (error) return self->close("the game controller has closed the connection");
      if (self->guarded([&] {
            self->session_.receive(std::string_view(self->input_.data(), size), steady_s());
          }))
        self->read();
    });
  }

  // Sends one message at a time; the next one follows the reply.
  void write(double now_s) {
    if (is_writing_) return;
    guarded([&] { output_ = session_.send(now_s); });
    if (phase_ != Phase::kOpen || output_.empty()) return;
    is_writing_ = true;
    const std::int64_t connection = connection_;
    asio::async_write(
        socket_, asio::buffer(output_),
        [self = shared_from_this(), connection](const error_code& error, std::size_t) {
          if (connection != self->connection_) return;
          self->is_writing_ = false;
          if (error) self->close(error.message());
        });
  }

  // Closes the connection if `talk` fails; returns whether `talk` succeeded.
  template <typename Talk>
  bool guarded(const Talk& talk) {
    try {
      talk();
      return true;
    } catch (const ControllerFault& fault) {
      close(fault.what());
      return false;
    }
  }

  void close(const std::string& problem) {
    if (phase_ == Phase::kOpen) ++losses_;
    phase_ = Phase::kClosed;
    ++connection_;  // answers still in transit do not count
    is_writing_ = false;
    retry_s_ = steady_s() + kRetry_s;
    if (!problem.empty()) problem_ = problem;
    error_code ignored;
    socket_.close(ignored);
    publish_status();
  }

  void publish_status() {
    const std::lock_guard lock(mutex_);
    const bool is_registered = phase_ == Phase::kOpen && session_.is_registered();
    status_ = {is_registered, session_.waiting(), session_.counts(),
               is_registered ? std::string() : problem_, losses_};
  }

  asio::io_context& io_;
  tcp::socket socket_;
  asio::steady_timer timer_;
  Address controller_;
  ControllerSession session_;
  Phase phase_ = Phase::kClosed;
  std::int64_t connection_ = 0;  // number of the current connection
  double retry_s_ = 0;
  double connecting_s_ = 0;
  bool is_writing_ = false;
  bool is_over_ = false;
  std::array<char, 4096> input_{};
  std::string output_;
  std::string problem_;
  std::int64_t losses_ = 0;
  mutable std::mutex mutex_;
  ControllerStatus status_;
};

ControllerClient::ControllerClient(NetworkThread& thread, const Address& controller,
                                   std::string identifier)
    : impl_(std::make_shared<Impl>(thread, controller, std::move(identifier))) {
  asio::post(impl_->io(), [impl = impl_] { impl->tick(); });
}

ControllerClient::~ControllerClient() {
  const auto deadline = std::chrono::steady_clock::now() + kLastEvents;
  for (ControllerStatus last = status(); last.is_registered && last.waiting > 0; last = status()) {
    if (std::chrono::steady_clock::now() >= deadline) break;
    std::this_thread::sleep_for(kTick);
  }
  std::promise<void> stopped;
  asio::post(impl_->io(), [&] {
    impl_->stop();
    stopped.set_value();
  });
  stopped.get_future().wait();
}

void ControllerClient::set_host(const std::string& host) {
  asio::post(impl_->io(), [impl = impl_, host] { impl->set_host(host); });
}

void ControllerClient::report(const GameEvent& event) {
  asio::post(impl_->io(), [impl = impl_, event] { impl->report(event); });
}

ControllerStatus ControllerClient::status() const { return impl_->status(); }

std::string controller_line(const ControllerStatus& controller) {
  std::string line = controller.is_registered ? "registered" : "not connected";
  const ControllerCounts& counts = controller.counts;
  line += fmt::format("; events: {} accepted, {} rejected, {} waiting, {} dropped", counts.accepted,
                      counts.rejected, controller.waiting, counts.dropped);
  if (controller.losses > 0) line += fmt::format("; {} connections lost", controller.losses);
  if (!controller.problem.empty()) line += "; " + controller.problem;
  if (!counts.last_rejection.empty()) line += "; last rejection: " + counts.last_rejection;
  return line;
}

}  // namespace autoref::live
