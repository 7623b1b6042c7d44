#include "league/record_reader.hpp"

#include <algorithm>
#include <functional>

#include "league/message_fields.hpp"
#include "league/vision_message.hpp"

namespace autoref::league {
namespace {

constexpr std::uint64_t kLongestDelay_us = 1'000'000;

template <typename Packet>
Packet& packet_of(ParsedMessage& message) {
  auto* const last = std::get_if<Packet>(&message.packet);
  return last != nullptr ? *last : message.packet.emplace<Packet>();
}

bool parse_2010(const std::string& bytes, VisionPacket& packet) {
  VisionPacket2010 old;
  if (!parse(bytes, old)) return false;
  convert(old, packet);
  return true;
}

bool parse_packet(MessageKind kind, const std::string& bytes, ParsedMessage& message) {
  switch (kind) {
    case MessageKind::kVision2014:
      return parse(bytes, packet_of<VisionPacket>(message));
    case MessageKind::kVision2010:
      return parse_2010(bytes, packet_of<VisionPacket>(message));
    case MessageKind::kTracker2020:
      return parse(bytes, packet_of<TrackerPacket>(message));
    case MessageKind::kReferee2013:
      return parse(bytes, packet_of<RefereePacket>(message));
    default:
      message.packet = std::monostate();
      return true;
  }
}

}  // namespace

void parse(MessageKind kind, const std::string& bytes, ParsedMessage& message) {
  message.is_readable = parse_packet(kind, bytes, message);
  message.hash = std::hash<std::string>()(bytes);
}

ReadResult RecordReader::read(MessageKind kind, const std::string& bytes, double now_s,
                              const std::string& sender) {
  ParsedMessage& message = parsed_[kind];
  parse(kind, bytes, message);
  return read(message, now_s, sender);
}

ReadResult RecordReader::read(const ParsedMessage& message, double now_s,
                              const std::string& sender) {
  now_s_ = now_s;
  const ReadResult result = dispatch(message, sender);
  faults_.unreadable += result == ReadResult::kUnreadable ? 1 : 0;
  faults_.late += result == ReadResult::kLate ? 1 : 0;
  faults_.copies += result == ReadResult::kCopy ? 1 : 0;
  faults_.of_other_referee += result == ReadResult::kOtherReferee ? 1 : 0;
  return result;
}

MessageFaults RecordReader::faults() const {
  MessageFaults faults = faults_;
  faults.referee = referee_source_.name();
  faults.other_referee = referee_source_.ignored_name();
  faults.referee_changes = referee_source_.changes();
  faults.clocks_ahead_s = merger_.clocks().ahead_s();
  faults.clock_restarts = merger_.clocks().restarts();
  return faults;
}

ReadResult RecordReader::dispatch(const ParsedMessage& message, const std::string& sender) {
  if (!message.is_readable) return ReadResult::kUnreadable;
  if (const auto* vision = std::get_if<VisionPacket>(&message.packet))
    return read_vision(*vision, message.hash);
  if (const auto* tracker = std::get_if<TrackerPacket>(&message.packet))
    return read_tracker(*tracker, message.hash);
  if (const auto* referee = std::get_if<RefereePacket>(&message.packet))
    return read_referee(*referee, message.hash, sender);
  return ReadResult::kUsed;
}

// Whether the message is a copy of a recent one. Different messages of a game always differ, since
// each contains its time.
bool RecordReader::is_copy(std::size_t hash) {
  if (std::find(recent_.begin(), recent_.end(), hash) != recent_.end()) return true;
  recent_[compared_++ % recent_.size()] = hash;
  return false;
}

ReadResult RecordReader::read_vision(const VisionPacket& packet, std::size_t hash) {
  // Geometry does not change from packet to packet.
  if (packet.has_detection() && is_copy(hash)) return ReadResult::kCopy;
  const std::int64_t late = merger_.late();
  const std::int64_t unusable = merger_.unusable();
  show(merger_.add(packet, now_s_));
  if (merger_.unusable() != unusable) return ReadResult::kUnreadable;
  if (merger_.late() != late) return ReadResult::kLate;
  visitor_.on_vision(now_s_, packet);
  return ReadResult::kUsed;
}

ReadResult RecordReader::read_tracker(const TrackerPacket& packet, std::size_t hash) {
  if (is_copy(hash)) return ReadResult::kCopy;
  const std::int64_t unusable = follower_.unusable();
  const bool has_tracks = follower_.add(packet, now_s_);
  if (has_tracks) visitor_.on_tracks(follower_.frame(), follower_.tracks());
  if (has_tracks && frames_are_tracked_) count_and_show(follower_.frame());
  return follower_.unusable() == unusable ? ReadResult::kUsed : ReadResult::kUnreadable;
}

ReadResult RecordReader::read_referee(const RefereePacket& packet, std::size_t hash,
                                      const std::string& sender) {
  const std::string& name = packet.source_identifier();
  if (!referee_source_.follows(name.empty() ? sender : name, now_s_))
    return ReadResult::kOtherReferee;
  if (is_copy(hash)) return ReadResult::kCopy;
  // A packet that is a little older than the last one was overtaken by it. If the step back in time
  // is larger, the referee's clock was set.
  const std::uint64_t sent_us = packet.packet_timestamp();
  const bool is_same = referee_changes_ == referee_source_.changes();
  if (is_same && sent_us < referee_sent_us_ && referee_sent_us_ - sent_us < kLongestDelay_us)
    return ReadResult::kLate;
  referee_changes_ = referee_source_.changes();
  referee_sent_us_ = sent_us;
  visitor_.on_referee(now_s_, packet);
  return ReadResult::kUsed;
}

// A frame of vision.
void RecordReader::show(const Frame* frame) {
  if (frame != nullptr && !frames_are_tracked_) count_and_show(*frame);
}

void RecordReader::count_and_show(const Frame& frame) {
  ++frames_;
  visitor_.on_frame(frame);
}

}  // namespace autoref::league
