// Reads a complete log: frames, referee messages and a summary.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "league/field_message.hpp"
#include "league/log_file.hpp"
#include "league/messages/referee.pb.h"
#include "league/messages/vision.pb.h"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/tracks.hpp"

namespace autoref::league {

// The source of a log's frames. Unless a source is chosen, frames come from the log's tracker only
// if the log begins without vision packets.
enum class FrameSource : std::uint8_t { kFirst, kVision, kTracker };

// Receives a log's contents in the order of the file.
class LogVisitor {
 public:
  virtual ~LogVisitor() = default;
  // A complete frame (detection_merger.hpp). It is reported once the next frame begins, that is,
  // after the referee messages sent between the two. Its time counts from the first frame. Frames
  // can also come from the log's tracker (FrameSource, tracker_message.hpp).
  virtual void on_frame(const Frame& /*frame*/) {}
  // The tracks reported by the log's tracker, and a frame of the objects that it saw. The frame
  // numbers and times of both are counted from the tracker's first packet. Called before on_frame
  // if the frames come from the tracker.
  virtual void on_tracks(const Frame& /*frame*/, const Tracks& /*tracks*/) {}
  // `time_s` is the record's time on the frames' clock.
  virtual void on_referee(double /*time_s*/, const RefereePacket& /*packet*/) {}
  // A vision packet that could be used: a camera's detections, geometry, or both. `time_s` is the
  // record's time on the frames' clock.
  virtual void on_vision(double /*time_s*/, const VisionPacket& /*packet*/) {}
};

// What the reader did with a message.
enum class ReadResult : std::uint8_t { kUsed, kUnreadable, kLate, kCopy, kOtherReferee };

// Messages that were not passed on, and corrections to the other messages.
struct MessageFaults {
  std::int64_t unreadable = 0;  // messages that cannot be parsed or used
  // Messages that are not newer than those already used from the same camera or referee, or whose
  // time is given by a clock that is not known yet.
  std::int64_t late = 0;
  std::int64_t copies = 0;            // copies of messages received shortly before
  std::int64_t of_other_referee = 0;  // packets from a referee that is not followed
  // The names that the followed referee and the first other referee give themselves. These names
  // can contain any bytes.
  std::string referee;
  std::string other_referee;
  int referee_changes = 0;  // how often another referee was followed from then on
  std::map<std::uint32_t, double> clocks_ahead_s;  // CameraClocks::ahead_s()
  int clock_restarts = 0;                          // restarts of the cameras' clocks
};

// Summary of a log, in addition to the visitors' data.
struct LogSummary {
  // Indexed by MessageKind; messages of an unknown kind count as kUnknown.
  std::map<MessageKind, std::int64_t> records;
  std::int64_t first_ns = 0;  // time of the first record; Unix time in the league's logs
  double length_s = 0;        // time from the first record to the last
  std::int64_t frames = 0;
  std::optional<Field> field;  // from the last geometry; nullopt if the log has none
  FieldGaps field_gaps;        // optional parts missing from that geometry
  int field_changes = 0;       // changes after the first geometry
  int trackers = 0;  // number of programs that sent tracker packets; at most 64 are counted
  bool frames_are_tracked = false;           // whether the frames come from a tracker
  FrameSource source = FrameSource::kFirst;  // the frame source that was requested
  std::int64_t unnumbered = 0;               // detections of robots numbered 16 and above
  MessageFaults faults;
  std::int64_t unreadable_at = 0;   // offset of the first unreadable message, in bytes
  std::optional<LogDamage> damage;  // set if the log ends prematurely
};

// Limits the time and memory spent on a log. The limits allow for nine hours with eight cameras at
// 60 frames per second, which is longer than any game.
struct LogLimits {
  std::int64_t frames = 2'000'000;
  std::int64_t records = 20'000'000;
  std::int64_t bytes = std::int64_t{32} << 30;  // uncompressed
};

// Reads a log in bounded memory. Throws LogError if the file is not a log. A log that exceeds the
// limits counts as damaged from that point on.
LogSummary read_log(const std::filesystem::path& path, LogVisitor& visitor,
                    const LogLimits& limits = {}, FrameSource source = FrameSource::kFirst);
LogSummary read_log(const std::filesystem::path& path, LogVisitor& visitor, FrameSource source);

}  // namespace autoref::league
