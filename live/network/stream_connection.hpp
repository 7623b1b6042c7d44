// One connection of a StreamServer. For files that use Asio.
#pragma once

#include "live/network/network_context.hpp"

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "live/network/network.hpp"

namespace autoref::live {

// Reads messages and writes responses. All functions are called in the network's thread.
class StreamConnection : public std::enable_shared_from_this<StreamConnection> {
 public:
  enum class End { kClosed, kInvalid, kUnread };
  using Clock = std::chrono::steady_clock;

  // Returns the response; nullopt: none at once.
  using OnMessage = DatagramReceiver::Handler;
  // Called once, just before the connection is closed, unless close() is.
  using OnEnd = std::function<void(const StreamConnection& connection, End why)>;

  StreamConnection(boost::asio::ip::tcp::socket socket, OnMessage on_message, OnEnd on_end);

  void start() { read(); }
  void send(std::string_view message);
  void close();

  const Address& peer() const { return peer_; }
  // When the last message came, or the connection was made.
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
  std::string received_;  // not yet a whole message
  std::string waiting_;   // to be written
  std::string written_;   // being written
  bool is_writing_ = false;
  bool is_open_ = true;
};

}  // namespace autoref::live
