#include "league/log_contents.hpp"

#include <fmt/format.h>

#include "league/message_fields.hpp"
#include "league/messages/tracker.pb.h"
#include "league/messages/vision.pb.h"
#include "league/record_reader.hpp"
#include "league/vision_message.hpp"

namespace autoref::league {
namespace {

constexpr double kOutOfOrder_s = 1;  // maximum step back in time within one log
constexpr double kLongestPause_s = 1e6;

// The kind of a message for which the log does not give the kind. A message is of a kind if it has
// everything that messages of that kind must have.
MessageKind guessed_kind(const std::string& bytes) {
  VisionPacket vision;
  if (parse(bytes, vision) && (vision.has_detection() || vision.has_geometry()))
    return MessageKind::kVision2014;
  RefereePacket referee;
  if (parse(bytes, referee)) return MessageKind::kReferee2013;
  VisionPacket2010 old;
  if (parse(bytes, old) && (old.has_detection() || old.has_geometry()))
    return MessageKind::kVision2010;
  TrackerPacket tracker;
  if (parse(bytes, tracker) && tracker.has_tracked_frame()) return MessageKind::kTracker2020;
  return MessageKind::kUnknown;
}

MessageKind kind_of(const LogRecord& record) {
  if (record.kind == static_cast<std::int32_t>(MessageKind::kUnknown))
    return guessed_kind(record.message);
  const bool is_known = record.kind >= static_cast<std::int32_t>(MessageKind::kUnknown) &&
                        record.kind <= static_cast<std::int32_t>(MessageKind::kIndex2021);
  return is_known ? static_cast<MessageKind>(record.kind) : MessageKind::kUnknown;
}

bool has_detection(const LogRecord& record) {
  VisionPacket packet;
  VisionPacket2010 old;
  const MessageKind kind = kind_of(record);
  return (kind == MessageKind::kVision2014 && parse(record.message, packet) &&
          packet.has_detection()) ||
         (kind == MessageKind::kVision2010 && parse(record.message, old) && old.has_detection());
}

// Whether the log's first records contain tracker packets, but no vision.
bool begins_with_tracker_only(const std::filesystem::path& path) {
  constexpr int kBeginning = 3000;  // number of records: a few seconds of a game with two trackers
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
        limits_(limits),
        source_(source),
        frames_are_tracked_(source == FrameSource::kFirst ? begins_with_tracker_only(path)
                                                          : source == FrameSource::kTracker),
        reader_(visitor, frames_are_tracked_) {}

  LogSummary summary() {
    while (!beyond() && log_.read(record_)) {
      const MessageKind kind = kind_of(record_);
      ++summary_.records[kind];
      if (kind == MessageKind::kIndex2021) continue;  // an index has no time
      if (records_++ == 0) first_ns_ = record_.time_ns;
      take_time();
      const bool is_first = !has_unreadable_;
      has_unreadable_ |= reader_.read(kind, record_.message, now_s_) == ReadResult::kUnreadable;
      if (is_first && has_unreadable_) summary_.unreadable_at = log_.offset();
    }
    reader_.finish();
    const DetectionMerger& merger = reader_.merger();
    summary_.first_ns = first_ns_;
    summary_.length_s = now_s_;
    summary_.frames = reader_.frames();
    summary_.field = merger.field();
    summary_.field_gaps = merger.field_gaps();
    summary_.field_changes = merger.field_changes();
    summary_.trackers = reader_.trackers();
    summary_.frames_are_tracked = frames_are_tracked_;
    summary_.source = source_;
    summary_.faults = reader_.faults();
    summary_.unnumbered = merger.unnumbered();
    const std::optional<std::string> too_much = beyond();
    summary_.damage = too_much ? LogDamage{log_.offset(), *too_much} : log_.damage();
    return summary_;
  }

 private:
  // If record times jump, as in two concatenated logs, times continue from the last record. The
  // difference is computed in double, since the difference of malicious times may overflow int64.
  void take_time() {
    const double since_first_s =
        (static_cast<double>(record_.time_ns) - static_cast<double>(first_ns_)) / 1e9;
    const double step_s = since_first_s + leaps_s_ - now_s_;
    if (step_s < -kOutOfOrder_s || step_s > kLongestPause_s) leaps_s_ -= step_s;
    now_s_ = since_first_s + leaps_s_;
  }

  std::optional<std::string> beyond() const {
    if (reader_.frames() >= limits_.frames)
      return fmt::format("more than {} frames", limits_.frames);
    if (records_ >= limits_.records) return fmt::format("more than {} messages", limits_.records);
    if (log_.offset() < limits_.bytes) return std::nullopt;
    return fmt::format("more than {} bytes once decompressed", limits_.bytes);
  }

  LogReader log_;
  LogLimits limits_;
  LogRecord record_;
  FrameSource source_;
  bool frames_are_tracked_;
  RecordReader reader_;
  LogSummary summary_;
  bool has_unreadable_ = false;
  std::int64_t records_ = 0;
  std::int64_t first_ns_ = 0;
  double leaps_s_ = 0;  // total shift applied to record times
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
