// The packets that a live referee sends, and the status that it prints.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "league/game_packets.hpp"
#include "league/messages/tracker.pb.h"
#include "league/tracker_message.hpp"
#include "live/controller/controller_reporter.hpp"
#include "live/network/network.hpp"
#include "live/referee/live_referee.hpp"
#include "referee/decision.hpp"
#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rules/game_event.hpp"
#include "soccer/tracks.hpp"

namespace autoref::live {

struct LiveRefereeOptions;

// Sends nothing unless AutoRef commands the game or reports to the game controller.
class RefereeOutputs final : league::PacketSink {
 public:
  RefereeOutputs(const LiveRefereeOptions& options, const Field& field,
                 const PerSide<std::string>& names);

  // Sets the Unix time of the frames' time 0.
  void set_start(const std::optional<double>& start_unix_s);

  // Records the sender of the referee packets, which is assumed to be the game controller's host
  // unless another one was given.
  void note_referee(const std::string& host);

  // Sends the tracks of a frame. `is_turned`: they are rotated with respect to the field.
  void send_tracks(const Tracks& tracks, bool is_turned);

  // Records a command or event for the next referee packets.
  void note(const referee::Decision& decision);

  // Sends a referee packet if the signal has changed, and every 25 ms. `time_s` is on the frames'
  // clock.
  void send_signal(const RefereeSignal& signal, double time_s);

  // Reports an event to the game controller.
  void report(const GameEvent& event);

  std::optional<ControllerStatus> controller_status() const;

 private:
  void on_vision(double /*time_s*/, const league::VisionPacket& /*packet*/) override {}
  void on_referee(double time_s, const league::RefereePacket& packet) override;

  bool commands_;
  double start_unix_s_ = 0;
  double latest_s_ = 0;
  league::TrackerSource source_;
  std::optional<league::GamePackets> packets_;
  std::optional<DatagramSender> referee_;
  std::optional<DatagramSender> tracker_;
  std::optional<ControllerReporter> controller_;
  league::TrackerPacket tracker_packet_;
  std::string bytes_;
};

// A line such as "12:34.5  ball_left_field yellow: ...". Empty for decisions that only follow
// another referee's commands.
std::string call_line(const referee::Decision& decision);

// "stage FIRST_HALF, STOP, yellow 1 : 0 blue".
std::string state_line(const LiveRefereeStatus& status);

// The whole status display: text with line breaks, at most `columns` wide. `calls` are the latest
// calls, the newest last.
std::string status_text(const LiveRefereeStatus& status, const std::deque<std::string>& calls,
                        std::size_t columns);

}  // namespace autoref::live
