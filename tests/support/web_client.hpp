// A browser for tests: a socket that sends and reads bytes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace autoref {

class WebClient {
 public:
  // `receive_buffer` limits the unread bytes that the system keeps for this client, approximately.
  // `from` is the client's own address.
  explicit WebClient(int port, std::optional<int> receive_buffer = std::nullopt,
                     const char* from = "127.0.0.1");
  ~WebClient();
  WebClient(const WebClient&) = delete;
  WebClient& operator=(const WebClient&) = delete;

  // Returns whether the system took all bytes; it does not if the connection is closed.
  bool send(std::string_view bytes) const;

  // Everything until the server closes the connection.
  std::string rest();

  // The next header, up to the empty line that ends it.
  std::string header();

  // The next text message of a WebSocket; nullopt if the server has closed the connection.
  std::optional<std::string> message();

 private:
  bool read_some();
  bool await(std::size_t bytes);  // until they are in the buffer

  int socket_;
  std::string buffer_;
};

// A request for a WebSocket at /live.
std::string upgrade_request(int port, std::string_view further_fields = "");

// A text frame as a browser sends it.
std::string text_frame(std::string_view text);

// The answer to a request.
std::string answer(int port, std::string_view request);

}  // namespace autoref
