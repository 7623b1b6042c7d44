// The connection to a game controller in CI mode (TCP port 10009).
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "league/messages/game_controller.pb.h"
#include "live/network/network.hpp"

namespace autoref::live {

inline constexpr int kCiPort = 10009;

// Sends inputs and reads outputs; every wait is bounded. All functions throw InputError if the
// controller cannot be reached, closes the connection or sends something invalid.
class CiConnection {
 public:
  // The longest wait for an output.
  static constexpr std::chrono::seconds kLongestAnswer{10};

  // `controller.host` can be a name.
  explicit CiConnection(const Address& controller);
  ~CiConnection();
  CiConnection(const CiConnection&) = delete;
  CiConnection& operator=(const CiConnection&) = delete;

  // Sends an input, waits for an output, and reads those that follow immediately. Each input causes
  // one or more outputs, so some of those read may belong to an earlier input. Returns the newest
  // output.
  league::CiOutput exchange(const league::CiInput& input);

 private:
  void write(const std::string& bytes);
  // Reads what arrives within `longest_wait`. Returns whether anything arrived.
  bool read(std::chrono::milliseconds longest_wait);
  std::optional<league::CiOutput> next_output();
  [[noreturn]] void fail(const std::string& what) const;

  std::string name_;
  int socket_ = -1;
  std::string input_;
};

}  // namespace autoref::live
