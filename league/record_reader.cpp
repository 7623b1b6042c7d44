#include "league/record_reader.hpp"

#include "league/partial_parse.hpp"

namespace autoref::league {

bool RecordReader::take(MessageKind kind, const std::string& bytes, double now_s) {
  now_s_ = now_s;
  switch (kind) {
    case MessageKind::kVision2014:
      return parse(bytes, vision_) && take_vision();
    case MessageKind::kVision2010:
      if (!parse(bytes, vision_2010_)) return false;
      convert(vision_2010_, vision_);
      return take_vision();
    case MessageKind::kTracker2020:
      return parse(bytes, tracker_) && take_tracker();
    case MessageKind::kReferee2013:
      if (!parse(bytes, referee_)) return false;
      visitor_.on_referee(now_s, referee_);
      return true;
    default:
      return true;
  }
}

bool RecordReader::take_vision() {
  const std::int64_t unusable = merger_.unusable();
  show(merger_.add(vision_, now_s_));
  if (merger_.unusable() != unusable) return false;
  visitor_.on_vision(now_s_, vision_);
  return true;
}

bool RecordReader::take_tracker() {
  const std::int64_t unusable = follower_.unusable();
  const bool has_tracks = follower_.add(tracker_, now_s_);
  if (has_tracks) visitor_.on_tracks(follower_.frame(), follower_.tracks());
  if (has_tracks && frames_are_tracked_) count_and_show(follower_.frame());
  return follower_.unusable() == unusable;
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
