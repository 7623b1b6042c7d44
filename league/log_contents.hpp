// A log from beginning to end: its frames and what the referee sent, and what there was besides.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

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
  std::optional<Field> field;       // none where the log has no geometry
  std::int64_t unreadable = 0;      // messages that are none of their kind, or make no sense
  std::int64_t unreadable_at = 0;   // the first of these: where its record begins
  std::optional<LogDamage> damage;  // the log ends here, too early
};

// Nine hours at 60 frames a second: no game is longer, and what is made of a log stays bounded.
inline constexpr std::int64_t kMostFrames = 2'000'000;

// Reads the log of that name, in bounded memory. Throws LogError where it is none. A log of more
// frames counts as damaged behind them.
LogSummary read_log(const std::filesystem::path& path, LogVisitor& visitor);

}  // namespace autoref::league
