// Datagrams on the league's network. Nothing leaves this computer unless an interface is chosen.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace autoref::live {

inline constexpr const char* kLoopback = "127.0.0.1";
// The longest datagram that is read; longer ones are counted and dropped.
inline constexpr std::size_t kLongestDatagram = 8192;
// The longest datagram that can be sent over IPv4.
inline constexpr std::size_t kLongestSent = 65'507;

struct Address {
  std::string host;  // numeric IPv4 address
  int port = 0;
};

// The broadcast address of the interface's network; nullopt if it has none.
std::optional<std::string> broadcast_address(const std::string& interface);

// A thread that waits for packets and timers. All functions that it calls must return soon.
class NetworkThread {
 public:
  NetworkThread();
  ~NetworkThread();  // stops the thread
  NetworkThread(const NetworkThread&) = delete;
  NetworkThread& operator=(const NetworkThread&) = delete;

  class Context;  // network_context.hpp
  Context& context() { return *context_; }

 private:
  std::unique_ptr<Context> context_;
};

// Sends datagrams to a multicast group, to a host or to all hosts of a network. Sending never
// waits: datagrams that the system cannot accept immediately are dropped and counted. Multicast
// goes to one interface only and does not leave its network.
class DatagramSender {
 public:
  // `interface` is the address of the interface to send on. Throws InputError if an address is
  // invalid or `interface` is not an address of this computer.
  DatagramSender(const std::string& interface, const Address& to);
  ~DatagramSender();
  DatagramSender(DatagramSender&&) noexcept;
  DatagramSender& operator=(DatagramSender&&) noexcept;

  void send(std::string_view bytes);
  std::int64_t dropped() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

// Receives datagrams at a port or those of a multicast group.
class DatagramReceiver {
 public:
  // Called in the network's thread. Its result is sent back to the sender, even if it is an empty
  // message.
  using Handler =
      std::function<std::optional<std::string>(std::string_view bytes, const Address& from)>;

  // Where to receive. Port 0 means any free port. `group` is the address of a multicast group; if
  // it is empty, datagrams sent to this computer are received. Throws InputError if the port is in
  // use or an address is invalid; `flag` is the option that sets the port.
  struct Place {
    std::string interface = kLoopback;
    std::string group = {};
    int port = 0;
    std::string flag = {};
  };
  DatagramReceiver(NetworkThread& thread, const Place& place, Handler handler);
  ~DatagramReceiver();  // after this, the handler is no longer called
  DatagramReceiver(DatagramReceiver&&) noexcept;
  DatagramReceiver& operator=(DatagramReceiver&&) noexcept;

  // Sends a datagram from this port; can be called in any thread.
  void send(std::string bytes, const Address& to);

  int port() const;
  std::int64_t oversized() const;  // datagrams dropped because of their length

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace autoref::live
