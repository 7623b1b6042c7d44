// Connections of the league's network: TCP, each message preceded by its length.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "live/network/network.hpp"

namespace autoref::live {

// How many connections a port has at a time.
inline constexpr std::size_t kMostConnections = 4;
// Bytes that may wait for a program that does not read them; then its connection is closed.
inline constexpr std::size_t kMostUnread = 4 << 20;
// No response is longer.
inline constexpr std::size_t kLongestResponse = 2 << 20;

// After this time without a message, a connection gives way to a new one.
inline constexpr std::chrono::seconds kSilentConnection{2};

// What a port's connections were closed or refused for.
struct StreamTroubles {
  std::int64_t refused = 0;  // there were kMostConnections already
  std::int64_t invalid = 0;  // what came cannot begin a message of at most 64 KiB
  std::int64_t unread = 0;   // the program did not read its responses
};

// Accepts connections at a port and reads messages, each preceded by its length in bytes as a
// varint. Whatever a program sends or leaves unread, nothing waits for it.
class StreamServer {
 public:
  // Called in the network's thread. What it returns is sent back.
  using Handler = DatagramReceiver::Handler;

  // As DatagramReceiver; `place.group` is not used. Throws InputError if the port is in use.
  StreamServer(NetworkThread& thread, const DatagramReceiver::Place& place, Handler handler,
               std::chrono::milliseconds silent = kSilentConnection);
  ~StreamServer();  // closes all connections; after this, the handler is not called any more
  StreamServer(const StreamServer&) = delete;
  StreamServer& operator=(const StreamServer&) = delete;

  // Sends a message to the program at the other end; may be called in any thread. If its connection
  // is closed, nothing happens.
  void send(std::string message, const Address& to);

  int port() const;
  StreamTroubles troubles() const;  // may be called in any thread

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace autoref::live
