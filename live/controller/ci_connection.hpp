// The connection to a game controller in CI mode (TCP port 10009).
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "league/messages/game_controller.pb.h"
#include "live/network/network.hpp"

namespace autoref::live {

inline constexpr int kCiPort = 10009;

// Sends inputs and reads outputs; every wait is bounded. All functions throw InputError if the
// controller cannot be reached, closes the connection or sends something invalid.
//
// The controller answers each input's tick with one output and sends another one for each change to
// the match, whether an input asked for it, an event or the tick itself. Outputs do not say which
// of these they belong to, and changes may come later than the answer to the tick.
class CiConnection {
 public:
  // The longest wait for the answer to an input.
  static constexpr std::chrono::seconds kLongestAnswer{10};
  // No more outputs are expected after a silence of this length.
  static constexpr std::chrono::milliseconds kSilence{2};

  // `controller.host` can be a name.
  explicit CiConnection(const Address& controller);
  ~CiConnection();
  CiConnection(const CiConnection&) = delete;
  CiConnection& operator=(const CiConnection&) = delete;

  // Sends an input, waits for an output, and reads those that have already followed. Returns the
  // newest one. Outputs that arrived before are skipped.
  league::CiOutput exchange(const league::CiInput& input);

  // Sends an input without waiting for an answer.
  void send(const league::CiInput& input);

  using Condition = std::function<bool(const league::CiOutput&)>;
  // Reads outputs until one meets the condition, but at most for this long. Returns the newest one;
  // nullopt if there was none.
  std::optional<league::CiOutput> read_until(const Condition& condition,
                                             std::chrono::milliseconds longest);

  // Reads outputs until none has come for this long. Returns the newest one; nullopt if there was
  // none.
  std::optional<league::CiOutput> read_until_silence(std::chrono::milliseconds silence = kSilence);

 private:
  void write(const std::string& bytes);
  // Waits for an output until the deadline.
  std::optional<league::CiOutput> next_output_by(std::chrono::steady_clock::time_point deadline);
  // Reads what arrives within `longest_wait`. Returns whether anything arrived.
  bool read(std::chrono::milliseconds longest_wait);
  std::optional<league::CiOutput> next_output();
  [[noreturn]] void fail(const std::string& what) const;

  std::string name_;
  int socket_ = -1;
  std::string input_;
};

}  // namespace autoref::live
