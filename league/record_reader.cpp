#include "league/record_reader.hpp"

#include <algorithm>
#include <functional>

#include "league/partial_parse.hpp"

namespace autoref::league {
namespace {

constexpr std::uint64_t kLongestDelay_us = 1'000'000;

}  // namespace

Taken RecordReader::take(MessageKind kind, const std::string& bytes, double now_s,
                         const std::string& sender) {
  now_s_ = now_s;
  const Taken result = dispatch(kind, bytes, sender);
  faults_.unreadable += result == Taken::kUnreadable ? 1 : 0;
  faults_.late += result == Taken::kLate ? 1 : 0;
  faults_.copies += result == Taken::kCopy ? 1 : 0;
  faults_.of_other_referee += result == Taken::kOtherReferee ? 1 : 0;
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

Taken RecordReader::dispatch(MessageKind kind, const std::string& bytes,
                             const std::string& sender) {
  switch (kind) {
    case MessageKind::kVision2014:
      return parse(bytes, vision_) ? take_vision(bytes) : Taken::kUnreadable;
    case MessageKind::kVision2010:
      if (!parse(bytes, vision_2010_)) return Taken::kUnreadable;
      convert(vision_2010_, vision_);
      return take_vision(bytes);
    case MessageKind::kTracker2020:
      return parse(bytes, tracker_) ? take_tracker(bytes) : Taken::kUnreadable;
    case MessageKind::kReferee2013:
      return parse(bytes, referee_) ? take_referee(bytes, sender) : Taken::kUnreadable;
    default:
      return Taken::kUsed;
  }
}

// Whether the message is one of the last ones again: every message of a game contains its time.
bool RecordReader::is_copy(const std::string& bytes) {
  const std::size_t hash = std::hash<std::string>()(bytes);
  if (std::find(recent_.begin(), recent_.end(), hash) != recent_.end()) return true;
  recent_[compared_++ % recent_.size()] = hash;
  return false;
}

Taken RecordReader::take_vision(const std::string& bytes) {
  // Geometry does not change from packet to packet.
  if (vision_.has_detection() && is_copy(bytes)) return Taken::kCopy;
  const std::int64_t late = merger_.late();
  const std::int64_t unusable = merger_.unusable();
  show(merger_.add(vision_, now_s_));
  if (merger_.unusable() != unusable) return Taken::kUnreadable;
  if (merger_.late() != late) return Taken::kLate;
  visitor_.on_vision(now_s_, vision_);
  return Taken::kUsed;
}

Taken RecordReader::take_tracker(const std::string& bytes) {
  if (is_copy(bytes)) return Taken::kCopy;
  const std::int64_t unusable = follower_.unusable();
  const bool has_tracks = follower_.add(tracker_, now_s_);
  if (has_tracks) visitor_.on_tracks(follower_.frame(), follower_.tracks());
  if (has_tracks && frames_are_tracked_) count_and_show(follower_.frame());
  return follower_.unusable() == unusable ? Taken::kUsed : Taken::kUnreadable;
}

Taken RecordReader::take_referee(const std::string& bytes, const std::string& sender) {
  const std::string& name = referee_.source_identifier();
  if (!referee_source_.follows(name.empty() ? sender : name, now_s_)) return Taken::kOtherReferee;
  if (is_copy(bytes)) return Taken::kCopy;
  // A packet that a newer one has overtaken; after a larger step, the referee's clock was set.
  const std::uint64_t sent_us = referee_.packet_timestamp();
  const bool is_same = referee_changes_ == referee_source_.changes();
  if (is_same && sent_us < referee_sent_us_ && referee_sent_us_ - sent_us < kLongestDelay_us)
    return Taken::kLate;
  referee_changes_ = referee_source_.changes();
  referee_sent_us_ = sent_us;
  visitor_.on_referee(now_s_, referee_);
  return Taken::kUsed;
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
