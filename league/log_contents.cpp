#include "league/log_contents.hpp"

#include <fmt/format.h>

#include "league/detection_merger.hpp"
#include "league/messages/tracker.pb.h"
#include "league/messages/vision.pb.h"
#include "league/tracker_message.hpp"
#include "league/vision_2010.hpp"

namespace autoref::league {
namespace {

constexpr double kOutOfOrder_s = 1;  // maximum step back in time within one log
constexpr double kLongestPause_s = 1e6;

// Partial parsing keeps protobuf from printing its own messages to stderr.
template <typename Message>
bool parse(const std::string& bytes, Message& message) {
  return message.ParsePartialFromString(bytes) && message.IsInitialized();
}

MessageKind kind_of(const LogRecord& record) {
  const bool is_known = record.kind >= static_cast<std::int32_t>(MessageKind::kUnknown) &&
                        record.kind <= static_cast<std::int32_t>(MessageKind::kIndex2021);
  return is_known ? static_cast<MessageKind>(record.kind) : MessageKind::kUnknown;
}

bool has_detection(const LogRecord& record) {
  VisionPacket packet;
  VisionPacket2010 old;
  return (kind_of(record) == MessageKind::kVision2014 && parse(record.message, packet) &&
          packet.has_detection()) ||
         (kind_of(record) == MessageKind::kVision2010 && parse(record.message, old) &&
          old.has_detection());
}

// Whether the log's first records contain tracker packets, but no vision.
bool begins_with_tracker_only(const std::filesystem::path& path) {
  constexpr int kBeginning = 3000;  // records: some seconds of a game with two trackers
  LogReader log(path);
  LogRecord record;
  bool has_tracker = false;
  for (int i = 0; i < kBeginning && log.read(record); ++i) {
    if (has_detection(record)) return false;
    has_tracker = has_tracker || kind_of(record) == MessageKind::kTracker2020;
  }
  return has_tracker;
}

class Walk {
 public:
  Walk(const std::filesystem::path& path, LogVisitor& visitor, const LogLimits& limits,
       FrameSource source)
      : log_(path),
        visitor_(visitor),
        limits_(limits),
        source_(source),
        frames_are_tracked_(source == FrameSource::kFirst ? begins_with_tracker_only(path)
                                                          : source == FrameSource::kTracker) {}

  LogSummary summary() {
    while (!beyond() && log_.read(record_)) {
      ++summary_.records[kind_of(record_)];
      if (kind_of(record_) == MessageKind::kIndex2021) continue;  // it has no time
      if (records_++ == 0) first_ns_ = record_.time_ns;
      take_time();
      if (!take()) note_unreadable();
    }
    show(merger_.finish());
    summary_.first_ns = first_ns_;
    summary_.length_s = now_s_;
    summary_.frames = frames_;
    summary_.field = merger_.field();
    summary_.field_gaps = merger_.field_gaps();
    summary_.field_changes = merger_.field_changes();
    summary_.trackers = follower_.sources();
    summary_.frames_are_tracked = frames_are_tracked_;
    summary_.source = source_;
    summary_.clock_restarts = merger_.clock_restarts();
    summary_.unnumbered = merger_.unnumbered();
    const std::optional<std::string> too_much = beyond();
    summary_.damage = too_much ? LogDamage{log_.offset(), *too_much} : log_.damage();
    return summary_;
  }

 private:
  // If record times jump, as in two concatenated logs, they continue from the last one. Computed in
  // double: the difference of malicious times may overflow int64.
  void take_time() {
    const double since_first_s =
        (static_cast<double>(record_.time_ns) - static_cast<double>(first_ns_)) / 1e9;
    const double step_s = since_first_s + leaps_s_ - now_s_;
    if (step_s < -kOutOfOrder_s || step_s > kLongestPause_s) leaps_s_ -= step_s;
    now_s_ = since_first_s + leaps_s_;
  }

  std::optional<std::string> beyond() const {
    if (frames_ >= limits_.frames) return fmt::format("more than {} frames", limits_.frames);
    if (records_ >= limits_.records) return fmt::format("more than {} messages", limits_.records);
    if (log_.offset() < limits_.bytes) return std::nullopt;
    return fmt::format("more than {} bytes once decompressed", limits_.bytes);
  }

  bool take() {
    const MessageKind kind = kind_of(record_);
    if (kind == MessageKind::kVision2014) return parse(record_.message, vision_) && take_vision();
    if (kind == MessageKind::kVision2010) return take_vision_2010();
    if (kind == MessageKind::kTracker2020) return take_tracker();
    return kind != MessageKind::kReferee2013 || take_referee();
  }

  bool take_vision_2010() {
    if (!parse(record_.message, vision_2010_)) return false;
    convert(vision_2010_, vision_);
    return take_vision();
  }

  bool take_vision() {
    const std::int64_t unusable = merger_.unusable();
    show(merger_.add(vision_, now_s_));
    if (merger_.unusable() != unusable) return false;
    if (vision_.has_detection()) visitor_.on_camera(now_s_, vision_.detection().camera_id());
    return true;
  }

  bool take_referee() {
    if (!parse(record_.message, referee_)) return false;
    visitor_.on_referee(now_s_, referee_);
    return true;
  }

  bool take_tracker() {
    if (!parse(record_.message, tracker_)) return false;
    const std::int64_t unusable = follower_.unusable();
    const bool has_tracks = follower_.add(tracker_, now_s_);
    if (has_tracks) visitor_.on_tracks(follower_.frame(), follower_.tracks());
    if (has_tracks && frames_are_tracked_) count_and_show(follower_.frame());
    return follower_.unusable() == unusable;
  }

  // A frame of vision.
  void show(const Frame* frame) {
    if (frame != nullptr && !frames_are_tracked_) count_and_show(*frame);
  }

  void count_and_show(const Frame& frame) {
    ++frames_;
    visitor_.on_frame(frame);
  }

  void note_unreadable() {
    if (summary_.unreadable++ == 0) summary_.unreadable_at = log_.offset();
  }

  LogReader log_;
  LogVisitor& visitor_;
  LogLimits limits_;
  LogRecord record_;
  DetectionMerger merger_;
  FrameSource source_;
  bool frames_are_tracked_;
  TrackFollower follower_;
  VisionPacket vision_;
  VisionPacket2010 vision_2010_;
  RefereePacket referee_;
  TrackerPacket tracker_;
  LogSummary summary_;
  std::int64_t records_ = 0;
  std::int64_t frames_ = 0;
  std::int64_t first_ns_ = 0;
  double leaps_s_ = 0;  // total shift of the times
  double now_s_ = 0;    // time of the current record since the first
};

}  // namespace

LogSummary read_log(const std::filesystem::path& path, LogVisitor& visitor, const LogLimits& limits,
                    FrameSource source) {
  return Walk(path, visitor, limits, source).summary();
}

LogSummary read_log(const std::filesystem::path& path, LogVisitor& visitor, FrameSource source) {
  return read_log(path, visitor, LogLimits{}, source);
}

}  // namespace autoref::league
