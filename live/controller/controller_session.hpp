// The conversation of an automatic referee with the league's game controller (TCP port 10007).
#pragma once

#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <string_view>

#include "soccer/rules/game_event.hpp"

namespace autoref::live {

// The game controller sent something invalid.
class ControllerFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ControllerCounts {
  std::int64_t accepted = 0;  // events that the controller accepted
  std::int64_t rejected = 0;
  std::int64_t dropped = 0;    // events not sent because they were too old or too many were waiting
  std::string last_rejection;  // the controller's reason for the last rejection
};

// Works without sockets and clocks: the caller transfers the bytes and supplies the time, in
// seconds on any clock. Only one message at a time awaits its reply. After a lost connection, the
// unanswered event is sent again. Events that could not be sent for kLongestWait_s are dropped,
// since the controller would take them for new events.
class ControllerSession {
 public:
  static constexpr double kLongestWait_s = 10;
  static constexpr double kSignOfLife_s = 1;
  static constexpr double kLongestReply_s = 3;
  static constexpr std::size_t kMostWaiting = 64;  // maximum number of waiting events

  explicit ControllerSession(std::string identifier) : identifier_(std::move(identifier)) {}

  // Starts a new connection. The controller speaks first.
  void begin(double now_s);

  // Queues an event to report.
  void report(GameEvent event, double now_s);

  // Processes bytes from the controller. Throws ControllerFault if the bytes are not valid replies
  // or if the controller refuses the registration.
  void receive(std::string_view bytes, double now_s);

  // The bytes to send now, if any. Throws ControllerFault if a reply is overdue for too long.
  std::string send(double now_s);

  bool is_registered() const { return phase_ == Phase::kRegistered; }
  std::size_t waiting() const { return events_.size(); }
  const ControllerCounts& counts() const { return counts_; }

 private:
  enum class Phase : std::uint8_t { kGreeting, kRegistering, kRegistered };
  enum class Sent : std::uint8_t { kNothing, kRegistration, kEvent, kSignOfLife };
  struct Report {
    GameEvent event;
    double at_s = 0;
  };

  void take_reply(int status, const std::string& reason);
  void drop_old(double now_s);

  std::string identifier_;
  Phase phase_ = Phase::kGreeting;
  Sent sent_ = Sent::kNothing;  // the message that was sent and has not been answered yet
  double sent_s_ = 0;
  std::deque<Report> events_;
  std::string input_;
  ControllerCounts counts_;
};

}  // namespace autoref::live
