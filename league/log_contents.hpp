// A log from beginning to end: its frames and what the referee sent, and what there was besides.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "league/field_message.hpp"
#include "league/log_file.hpp"
#include "league/messages/referee.pb.h"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::league {

// Looks at a log's contents, in the order in which they stand there.
class LogVisitor {
 public:
  virtual ~LogVisitor() = default;
  // A whole frame (detection_merger.hpp). It comes once the next one begins, so behind what the
  // referee sent meanwhile; its time counts from the first frame.
  virtual void on_frame(const Frame& /*frame*/) {}
  // `time_s` is that of the record, on the frames' clock.
  virtual void on_referee(double /*time_s*/, const RefereePacket& /*packet*/) {}
  // A packet of one camera; its time is that of the record, on the frames' clock.
  virtual void on_camera(double /*time_s*/, std::uint32_t /*camera*/) {}
};

// What a log holds apart from what visitors are told.
struct LogSummary {
  // By MessageKind; other numbers count as kUnknown.
  std::map<MessageKind, std::int64_t> records;
  double length_s = 0;  // from the first record to the last
  std::int64_t frames = 0;
  std::optional<Field> field;       // of the last geometry; none where the log has none
  FieldGaps field_gaps;             // what that geometry leaves out
  int field_changes = 0;            // other fields after the first
  int clock_restarts = 0;           // of the cameras
  std::int64_t unnumbered = 0;      // detections of robots numbered 16 and above
  std::int64_t unreadable = 0;      // messages that are none of their kind, or make no sense
  std::int64_t unreadable_at = 0;   // the first of these: where its record begins
  std::optional<LogDamage> damage;  // the log ends here, too early
};

// Nine hours at 60 frames a second of eight cameras: no game is longer, and what is made of a log,
// and how long it takes, stays bounded.
struct LogLimits {
  std::int64_t frames = 2'000'000;
  std::int64_t records = 20'000'000;
  std::int64_t bytes = std::int64_t{32} << 30;  // uncompressed
};

// Reads the log of that name, in bounded memory. Throws LogError where it is none. A log that goes
// beyond the limits counts as damaged behind them.
LogSummary read_log(const std::filesystem::path& path, LogVisitor& visitor,
                    const LogLimits& limits = {});

}  // namespace autoref::league
