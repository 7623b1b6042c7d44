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
// controller is not there, closes the connection, or says something that cannot be understood.
class CiConnection {
 public:
  // The longest wait for an output.
  static constexpr std::chrono::seconds kLongestAnswer{10};

  // `controller.host` may be a name.
  explicit CiConnection(const Address& controller);
  ~CiConnection();
  CiConnection(const CiConnection&) = delete;
  CiConnection& operator=(const CiConnection&) = delete;

  // Sends an input, waits for an output, and reads those that follow at once. An input has one or
  // more outputs, so some of an earlier input's may be among them. Returns the newest.
  league::CiOutput exchange(const league::CiInput& input);

 private:
  void write(const std::string& bytes);
  // Reads what has come within the time. Returns whether there was anything.
  bool read(std::chrono::milliseconds longest_wait);
  std::optional<league::CiOutput> next_output();
  [[noreturn]] void fail(const std::string& what) const;

  std::string name_;
  int socket_ = -1;
  std::string input_;
};

}  // namespace autoref::live
