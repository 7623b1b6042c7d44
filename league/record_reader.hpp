// Turns the league's messages, from a log or from the network, into frames and referee packets.
#pragma once

#include <cstdint>
#include <string>

#include "league/detection_merger.hpp"
#include "league/log_contents.hpp"
#include "league/log_file.hpp"
#include "league/messages/referee.pb.h"
#include "league/messages/tracker.pb.h"
#include "league/messages/vision.pb.h"
#include "league/tracker_message.hpp"
#include "league/vision_2010.hpp"

namespace autoref::league {

class RecordReader {
 public:
  // `visitor` must outlive the reader. Its frames are those of vision or, if `frames_are_tracked`,
  // those of a tracker.
  RecordReader(LogVisitor& visitor, bool frames_are_tracked)
      : visitor_(visitor), frames_are_tracked_(frames_are_tracked) {}

  // Takes the next message; `now_s` is when it arrived, on the frames' clock. Returns false if it
  // cannot be parsed or used. Other kinds of messages are ignored.
  bool take(MessageKind kind, const std::string& bytes, double now_s);

  // Completes the last frame.
  void finish() { show(merger_.finish()); }

  std::int64_t frames() const { return frames_; }
  const DetectionMerger& merger() const { return merger_; }
  int trackers() const { return follower_.sources(); }

 private:
  bool take_vision();
  bool take_tracker();
  void show(const Frame* frame);
  void count_and_show(const Frame& frame);

  LogVisitor& visitor_;
  bool frames_are_tracked_;
  double now_s_ = 0;
  DetectionMerger merger_;
  TrackFollower follower_;
  VisionPacket vision_;
  VisionPacket2010 vision_2010_;
  RefereePacket referee_;
  TrackerPacket tracker_;
  std::int64_t frames_ = 0;
};

}  // namespace autoref::league
