// A program that connects to a TCP port of this computer.
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "league/team/delimited.hpp"

namespace autoref::live {

// Sends and receives messages that are preceded by their length. It waits for at most a minute.
class Caller {
 public:
  explicit Caller(int port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    constexpr timeval patience{60, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  }
  ~Caller() { ::close(socket_); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  // Returns whether everything was sent.
  bool send(std::string_view bytes) {
    return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(bytes.size());
  }
  bool say(std::string_view message) {
    std::string bytes;
    league::append_delimited(message, bytes);
    return send(bytes);
  }

  // The next message; "closed" if the connection is closed first.
  std::string hear() {
    for (;;) {
      if (const auto extent = league::find_delimited(received_)) {
        const std::string message = received_.substr(extent->begin, extent->size);
        received_.erase(0, extent->end);
        return message;
      }
      std::array<char, 4096> chunk{};
      const ssize_t size = recv(socket_, chunk.data(), chunk.size(), 0);
      if (size <= 0) return "closed";
      received_.append(chunk.data(), static_cast<std::size_t>(size));
    }
  }

  int port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }

 private:
  int socket_;
  std::string received_;
};

}  // namespace autoref::live
