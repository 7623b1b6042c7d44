// Conversion between tracks and the league's tracker packets, and the choice between several
// senders.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "league/messages/tracker.pb.h"
#include "soccer/frame.hpp"
#include "soccer/tracks.hpp"

namespace autoref::league {

// Decides which of several programs that send the same kind of packets is followed: the first one,
// until it has been silent for 1 s, and then the next one that sends a packet.
class FollowedSource {
 public:
  // Records a packet from the program `name`, which arrived at `received_s` on any clock. Returns
  // whether that program is followed.
  bool follows(std::string_view name, double received_s);

  // The name of the program followed, truncated after 64 bytes; empty before the first packet.
  const std::string& name() const { return name_; }
  int changes() const { return changes_; }  // how often another program was followed from then on
  int sources() const { return static_cast<int>(sources_.size()); }  // at most 64 are counted

  // The first program that was ignored; empty if there is none.
  const std::string& ignored_name() const { return ignored_name_; }

 private:
  std::set<std::string, std::less<>> sources_;
  std::string name_;
  std::string ignored_name_;
  double heard_s_ = 0;
  int changes_ = 0;
  bool has_ignored_ = false;
};

// A program that sends tracker packets.
struct TrackerSource {
  std::string uuid;  // unique for each run of the program
  std::string name;
  bool detects_flying_balls = false;  // whether the program knows the height of a ball
};

// Fills `packet` with the tracks at `unix_s`, the time of their frame. West is yellow. Objects that
// are not seen have the visibility 0.
void fill_tracker(const Tracks& tracks, const TrackerSource& source, double unix_s,
                  TrackerPacket& packet);

// Follows one of the trackers that send packets. If there are several balls, the most visible one
// is used or, among equals, the one nearest to the previous position. Ignores robots with a number
// outside the league's range or without a team, and objects whose position is not finite or more
// than 100 m away. A velocity that is not finite or too large becomes 0.
class TrackFollower {
 public:
  // Takes the next packet; `received_s` is its arrival time on any clock. Returns whether it
  // contains newer tracks, which frame() and tracks() then return. Frames are numbered from 0.
  // Their times are in seconds since the first frame and increase: packets older than the last
  // frame are ignored. If the tracker's clock jumps or another tracker is followed, times continue
  // with the time of arrival.
  bool add(const TrackerPacket& packet, double received_s);

  // The robots and the ball that the tracker saw, as if vision had reported them.
  const Frame& frame() const { return frame_; }
  const Tracks& tracks() const { return tracks_; }

  const FollowedSource& source() const { return source_; }  // named by uuid
  std::int64_t unusable() const { return unusable_; }       // packets without a valid time

 private:
  double time_of(double timestamp_s, double received_s);
  void take_robots(const TrackerFrame& tracked);
  void take_ball(const TrackerFrame& tracked);

  FollowedSource source_;
  int changes_ = 0;        // changes of the source before the last frame
  double offset_s_ = 0;    // added to the tracker's clock to give the frames' clock
  double received_s_ = 0;  // arrival time of the last frame
  std::int64_t frames_ = 0;
  std::int64_t unusable_ = 0;
  Frame frame_;
  Tracks tracks_;
};

}  // namespace autoref::league
