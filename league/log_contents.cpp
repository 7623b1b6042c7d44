#include "league/log_contents.hpp"

#include <fmt/format.h>

#include "league/detection_merger.hpp"
#include "league/messages/vision.pb.h"

namespace autoref::league {
namespace {

// Without protobuf's own messages on stderr.
template <typename Message>
bool parse(const std::string& bytes, Message& message) {
  return message.ParsePartialFromString(bytes) && message.IsInitialized();
}

MessageKind kind_of(const LogRecord& record) {
  const bool is_known = record.kind >= static_cast<std::int32_t>(MessageKind::kUnknown) &&
                        record.kind <= static_cast<std::int32_t>(MessageKind::kIndex2021);
  return is_known ? static_cast<MessageKind>(record.kind) : MessageKind::kUnknown;
}

class Walk {
 public:
  Walk(const std::filesystem::path& path, LogVisitor& visitor) : log_(path), visitor_(visitor) {}

  LogSummary summary() {
    while (frames_ < kMostFrames && log_.read(record_)) {
      if (records_++ == 0) first_ns_ = record_.time_ns;
      last_ns_ = record_.time_ns;
      ++summary_.records[kind_of(record_)];
      if (!take()) note_unreadable();
    }
    show(merger_.finish());
    summary_.length_s = since_first_s();
    summary_.frames = frames_;
    summary_.field = merger_.field();
    summary_.damage = frames_ < kMostFrames ? log_.damage() : too_many_frames();
    return summary_;
  }

 private:
  // Hostile times may lie farther apart than a difference of int64 can say.
  double since_first_s() const {
    return (static_cast<double>(last_ns_) - static_cast<double>(first_ns_)) / 1e9;
  }

  std::optional<LogDamage> too_many_frames() const {
    return LogDamage{log_.offset(), fmt::format("more than {} frames", kMostFrames)};
  }

  bool take() {
    const MessageKind kind = kind_of(record_);
    if (kind == MessageKind::kVision2014) return take_vision();
    return kind != MessageKind::kReferee2013 || take_referee();
  }

  bool take_vision() {
    if (!parse(record_.message, vision_)) return false;
    const std::int64_t unusable = merger_.unusable();
    show(merger_.add(vision_));
    if (merger_.unusable() != unusable) return false;
    if (vision_.has_detection())
      visitor_.on_camera(since_first_s(), vision_.detection().camera_id());
    return true;
  }

  bool take_referee() {
    if (!parse(record_.message, referee_)) return false;
    visitor_.on_referee(since_first_s(), referee_);
    return true;
  }

  void show(const Frame* frame) {
    if (frame == nullptr) return;
    ++frames_;
    visitor_.on_frame(*frame);
  }

  void note_unreadable() {
    if (summary_.unreadable++ == 0) summary_.unreadable_at = log_.offset();
  }

  LogReader log_;
  LogVisitor& visitor_;
  LogRecord record_;
  DetectionMerger merger_;
  VisionPacket vision_;
  RefereePacket referee_;
  LogSummary summary_;
  std::int64_t records_ = 0;
  std::int64_t frames_ = 0;
  std::int64_t first_ns_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace

LogSummary read_log(const std::filesystem::path& path, LogVisitor& visitor) {
  return Walk(path, visitor).summary();
}

}  // namespace autoref::league
