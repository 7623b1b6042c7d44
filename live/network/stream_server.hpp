// TCP connections on the league's network, with messages that are preceded by their length.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "live/network/network.hpp"

namespace autoref::live {

// Maximum number of simultaneous connections at a port.
inline constexpr std::size_t kMostConnections = 4;
// Maximum number of bytes that may wait for a program to read them; beyond it, the connection is
// closed.
inline constexpr std::size_t kMostUnread = 4 << 20;
// Maximum length of a response in bytes.
inline constexpr std::size_t kLongestResponse = 2 << 20;

// After this time without a message, a connection gives way to a new one.
inline constexpr std::chrono::seconds kSilentConnection{2};

// How many of a port's connections were closed or refused, by reason.
struct StreamTroubles {
  std::int64_t refused = 0;  // there were already kMostConnections connections
  std::int64_t invalid = 0;  // input that cannot begin a message of at most 64 KiB
  std::int64_t unread = 0;   // the program did not read its responses
};

// Accepts connections at a port and reads messages, each preceded by its length in bytes as a
// varint. The server never waits for a program, whatever the program sends or leaves unread.
class StreamServer {
 public:
  // Called in the network's thread. Its result is sent back.
  using Handler = DatagramReceiver::Handler;

  // Like the constructor of DatagramReceiver; `place.group` is not used. Throws InputError if the
  // port is in use.
  StreamServer(NetworkThread& thread, const DatagramReceiver::Place& place, Handler handler,
               std::chrono::milliseconds silent = kSilentConnection);
  ~StreamServer();  // closes all connections; after this, the handler is no longer called
  StreamServer(const StreamServer&) = delete;
  StreamServer& operator=(const StreamServer&) = delete;

  // Sends a message to the program at the other end; does nothing if its connection is closed. Can
  // be called in any thread.
  void send(std::string message, const Address& to);

  int port() const;
  StreamTroubles troubles() const;  // can be called in any thread

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace autoref::live
