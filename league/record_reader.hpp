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

// A message that is parsed once, however many readers receive it.
struct ParsedMessage {
  // Empty if readers ignore messages of this kind.
  std::variant<std::monostate, VisionPacket, TrackerPacket, RefereePacket> packet;
  bool is_readable = true;
  std::size_t hash = 0;  // hash of its bytes
};

// Parses `bytes` into `message`, whose memory is reused if its last packet was of the same type.
// Packets in the format of 2010 are converted to the current one.
void parse(MessageKind kind, const std::string& bytes, ParsedMessage& message);

class RecordReader {
 public:
  // `visitor` must outlive the reader. The reader's frames come from vision or, if
  // `frames_are_tracked`, from a tracker.
  RecordReader(LogVisitor& visitor, bool frames_are_tracked)
      : visitor_(visitor), frames_are_tracked_(frames_are_tracked) {}

  // Reads the next message, parsed or not, which arrived at `now_s` on the frames' clock. Ignored
  // messages and those of other kinds are not passed on. `sender` distinguishes referees that do
  // not send a name.
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
  int referee_changes_ = 0;               // changes of the followed referee before the last packet
  std::uint64_t referee_sent_us_ = 0;     // time of the last packet, on the referee's clock
  std::array<std::size_t, 64> recent_{};  // hashes of the last messages
  std::size_t compared_ = 0;
  MessageFaults faults_;
  // The last message of each kind, kept to reuse its memory.
  std::map<MessageKind, ParsedMessage> parsed_;
  std::int64_t frames_ = 0;
};

}  // namespace autoref::league
