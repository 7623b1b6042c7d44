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

// The source of a log's frames. Unless one is chosen, they come from the log's tracker only if the
// log begins without vision.
enum class FrameSource : std::uint8_t { kFirst, kVision, kTracker };

// Receives a log's contents in the order of the file.
class LogVisitor {
 public:
  virtual ~LogVisitor() = default;
  // A complete frame (detection_merger.hpp). It is reported once the next one begins, that is,
  // after the referee messages sent in between. Its time counts from the first frame. Frames can
  // also come from the log's tracker (FrameSource, tracker_message.hpp).
  virtual void on_frame(const Frame& /*frame*/) {}
  // The tracks reported by the log's tracker, and a frame of the objects that it saw. Both have
  // frame numbers and times counted from the tracker's first packet. Called before on_frame if the
  // frames come from the tracker.
  virtual void on_tracks(const Frame& /*frame*/, const Tracks& /*tracks*/) {}
  // `time_s` is the record's time on the frames' clock.
  virtual void on_referee(double /*time_s*/, const RefereePacket& /*packet*/) {}
  // A vision packet that could be used: a camera's detections, geometry, or both. `time_s` is the
  // record's time on the frames' clock.
  virtual void on_vision(double /*time_s*/, const VisionPacket& /*packet*/) {}
};

// How a message was treated.
enum class ReadResult : std::uint8_t { kUsed, kUnreadable, kLate, kCopy, kOtherReferee };

// Messages that were not passed on, and corrections to the others.
struct MessageFaults {
  std::int64_t unreadable = 0;  // cannot be parsed or used
  // Not newer than messages already used from the camera or the referee, or dated by a clock that
  // is not known yet.
  std::int64_t late = 0;
  std::int64_t copies = 0;            // copies of messages received shortly before
  std::int64_t of_other_referee = 0;  // packets from a referee that is not followed
  // The names that the followed referee and the first other one use for themselves. They can
  // contain any bytes.
  std::string referee;
  std::string other_referee;
  int referee_changes = 0;                         // how often following changed to another referee
  std::map<std::uint32_t, double> clocks_ahead_s;  // CameraClocks::ahead_s()
  int clock_restarts = 0;                          // of the cameras
};

// Summary of a log, in addition to the visitors' data.
struct LogSummary {
  // Indexed by MessageKind; unknown numbers count as kUnknown.
  std::map<MessageKind, std::int64_t> records;
  std::int64_t first_ns = 0;  // time of the first record; Unix time in the league's logs
  double length_s = 0;        // from the first record to the last
  std::int64_t frames = 0;
  std::optional<Field> field;                // from the last geometry; nullopt if the log has none
  FieldGaps field_gaps;                      // optional parts missing from that geometry
  int field_changes = 0;                     // changes after the first geometry
  int trackers = 0;                          // programs that sent tracker packets, at most 64
  bool frames_are_tracked = false;           // whether the frames come from a tracker
  FrameSource source = FrameSource::kFirst;  // as requested
  std::int64_t unnumbered = 0;               // detections of robots numbered 16 and above
  MessageFaults faults;
  std::int64_t unreadable_at = 0;   // offset of the first unreadable message, in bytes
  std::optional<LogDamage> damage;  // set if the log ends prematurely
};

// Limits the time and memory spent on a log. The limits allow nine hours of eight cameras at 60
// frames per second, longer than any game.
struct LogLimits {
  std::int64_t frames = 2'000'000;
  std::int64_t records = 20'000'000;
  std::int64_t bytes = std::int64_t{32} << 30;  // uncompressed
};

// Reads a log in bounded memory. Throws LogError if the file is not a log. A log that exceeds the
// limits counts as damaged from that point.
LogSummary read_log(const std::filesystem::path& path, LogVisitor& visitor,
                    const LogLimits& limits = {}, FrameSource source = FrameSource::kFirst);
LogSummary read_log(const std::filesystem::path& path, LogVisitor& visitor, FrameSource source);

}  // namespace autoref::league
