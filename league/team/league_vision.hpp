// The packets of the league's vision, for teams that know only the league's messages.
#pragma once

#include <string>
#include <vector>

#include "league/messages/vision.pb.h"
#include "league/team/team_messages.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::league {

// The detections of a team's frame in field coordinates. Without detections, they are what a
// perfect camera would see: the tracked positions, and the ball's height if it is known.
Frame field_frame_of(const TeamFrame& frame, Side side);

// Serializes frames as the packets of their cameras. A camera gets a number once it has seen a ball
// whose height vision does not know; until one has, there is one camera above the field's centre.
class LeagueVision {
 public:
  explicit LeagueVision(const Field& field);

  // An SSL_WrapperPacket with the geometry.
  const std::string& geometry() const { return geometry_; }

  // One packet per camera, after the geometry if it is due: once per second and with new cameras.
  // Valid until the next call.
  const std::vector<std::string>& packets_of(const Frame& frame);

 private:
  void note_camera(const Frame& frame);
  void write_geometry();

  Field field_;
  std::vector<CameraPosition> cameras_{CameraPosition{}};
  bool has_seen_a_camera_ = false;
  std::vector<VisionPacket> messages_;
  std::vector<std::string> packets_;
  std::string geometry_;
  double geometry_due_s_ = 0;
};

}  // namespace autoref::league
