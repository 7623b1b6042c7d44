#include "tests/support/web_client.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <stdexcept>

namespace autoref {
namespace {

constexpr int kPatience_s = 60;
constexpr unsigned kTextFrame = 0x81;
constexpr unsigned kOpcode = 0x0f;
constexpr unsigned kClose = 8;
constexpr unsigned kText = 1;

unsigned byte(const std::string& bytes, std::size_t index) {
  return static_cast<unsigned char>(bytes[index]);
}

}  // namespace

WebClient::WebClient(int port, std::optional<int> receive_buffer, const char* from)
    : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
  const timeval patience{kPatience_s, 0};
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
  if (receive_buffer)
    setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &*receive_buffer, sizeof(*receive_buffer));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  inet_pton(AF_INET, from, &address.sin_addr);
  if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
    throw std::runtime_error("cannot bind");
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
    throw std::runtime_error("cannot connect");
}

WebClient::~WebClient() { close(socket_); }

bool WebClient::send(std::string_view bytes) const {
  return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
         static_cast<ssize_t>(bytes.size());
}

bool WebClient::read_some() {
  char bytes[4096];
  const ssize_t count = recv(socket_, bytes, sizeof(bytes), 0);
  if (count > 0) buffer_.append(bytes, static_cast<std::size_t>(count));
  return count > 0;
}

bool WebClient::await(std::size_t bytes) {
  while (buffer_.size() < bytes)
    if (!read_some()) return false;
  return true;
}

std::string WebClient::rest() {
  while (read_some()) continue;
  return buffer_;
}

std::string WebClient::header() {
  std::size_t end = std::string::npos;
  while ((end = buffer_.find("\r\n\r\n")) == std::string::npos)
    if (!read_some()) return buffer_;
  std::string header = buffer_.substr(0, end);
  buffer_.erase(0, end + 4);
  return header;
}

std::optional<std::string> WebClient::message() {
  for (;;) {
    if (!await(2)) return std::nullopt;
    const unsigned opcode = byte(buffer_, 0) & kOpcode;
    std::size_t length = byte(buffer_, 1);
    std::size_t begin = 2;
    if (length == 126) {
      if (!await(4)) return std::nullopt;
      length = byte(buffer_, 2) << 8U | byte(buffer_, 3);
      begin = 4;
    }
    if (opcode == kClose || !await(begin + length)) return std::nullopt;
    std::string text = buffer_.substr(begin, length);
    buffer_.erase(0, begin + length);
    if (opcode == kText) return text;
  }
}

std::string upgrade_request(int port, std::string_view further_fields) {
  return fmt::format(
      "GET /live HTTP/1.1\r\nHost: localhost:{}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n{}\r\n",
      port, further_fields);
}

// Masked with zeros.
std::string text_frame(std::string_view text) {
  std::string frame;
  frame += static_cast<char>(kTextFrame);
  frame += static_cast<char>(0x80U | text.size());
  frame.append(4, '\0');
  return frame.append(text);
}

std::string answer(int port, std::string_view request) {
  WebClient client(port);
  client.send(request);
  return client.rest();
}

}  // namespace autoref
