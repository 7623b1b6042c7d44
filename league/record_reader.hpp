// Turns the league's messages, from a log or from the network, into frames and referee packets.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>

#include "league/detection_merger.hpp"
#include "league/log_contents.hpp"
#include "league/log_file.hpp"
#include "league/messages/referee.pb.h"
#include "league/messages/tracker.pb.h"
#include "league/messages/vision.pb.h"
#include "league/tracker_message.hpp"

namespace autoref::league {

// A message that is parsed once, however many readers take it.
struct ParsedMessage {
  // Empty if readers ignore messages of this kind.
  std::variant<std::monostate, VisionPacket, TrackerPacket, RefereePacket> packet;
  bool is_readable = true;
  std::size_t hash = 0;  // of its bytes
};

// Uses the message's memory again if its packet was of the same type. Packets of 2010 become
// packets of today.
void parse(MessageKind kind, const std::string& bytes, ParsedMessage& message);

class RecordReader {
 public:
  // `visitor` must outlive the reader. Its frames are those of vision or, if `frames_are_tracked`,
  // those of a tracker.
  RecordReader(LogVisitor& visitor, bool frames_are_tracked)
      : visitor_(visitor), frames_are_tracked_(frames_are_tracked) {}

  // Takes the next message, parsed or not; `now_s` is when it arrived, on the frames' clock.
  // Ignored messages are not passed on, and neither are those of other kinds. `sender`
  // distinguishes referees without a name.
  ReadResult read(const ParsedMessage& message, double now_s, const std::string& sender = {});
  ReadResult read(MessageKind kind, const std::string& bytes, double now_s,
                  const std::string& sender = {});

  // Completes the last frame.
  void finish() { show(merger_.finish()); }

  std::int64_t frames() const { return frames_; }
  const DetectionMerger& merger() const { return merger_; }
  int trackers() const { return follower_.source().sources(); }
  MessageFaults faults() const;

 private:
  ReadResult dispatch(const ParsedMessage& message, const std::string& sender);
  ReadResult read_vision(const VisionPacket& packet, std::size_t hash);
  ReadResult read_tracker(const TrackerPacket& packet, std::size_t hash);
  ReadResult read_referee(const RefereePacket& packet, std::size_t hash, const std::string& sender);
  bool is_copy(std::size_t hash);
  void show(const Frame* frame);
  void count_and_show(const Frame& frame);

  LogVisitor& visitor_;
  bool frames_are_tracked_;
  double now_s_ = 0;
  DetectionMerger merger_;
  TrackFollower follower_;
  FollowedSource referee_source_;
  int referee_changes_ = 0;               // before the last packet
  std::uint64_t referee_sent_us_ = 0;     // the last packet, on the referee's clock
  std::array<std::size_t, 64> recent_{};  // hashes of the last messages
  std::size_t compared_ = 0;
  MessageFaults faults_;
  std::map<MessageKind, ParsedMessage> parsed_;  // the last ones, for their memory
  std::int64_t frames_ = 0;
};

}  // namespace autoref::league
