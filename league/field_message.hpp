// The field as described by the league's vision.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "league/messages/vision.pb.h"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::league {

// Fills `geometry` with the field and the cameras; a camera's id is its index in `cameras`. The
// lines get the names that the league's vision uses.
void fill_geometry(const Field& field, std::span<const CameraPosition> cameras, Geometry& geometry);

// How a ball rolls and bounces. Sent to the receivers of the geometry.
struct BallModel {
  double slide_mps2 = 0;     // deceleration of a sliding ball
  double roll_mps2 = 0;      // deceleration of a rolling ball
  double switch_ratio = 0;   // ratio of the speed at which a ball begins to roll to the kick speed
  double first_hop_xy = 0;   // fraction of the horizontal speed kept at a chip's first bounce
  double later_hops_xy = 0;  // fraction of the horizontal speed kept at later bounces
  double hops_z = 0;         // fraction of the vertical speed kept at each bounce
};

void fill_ball_models(const BallModel& model, Geometry& geometry);

// The field described by a message. Values that messages do not contain, for example the thickness
// of the goal walls, keep Field's defaults. Throws std::invalid_argument if a length is not
// positive (a margin may be 0) or exceeds 100 m.
Field field_of(const Geometry& geometry);

// The optional parts that are missing from a message.
struct FieldGaps {
  bool penalty_mark = false;
  bool defence_area = false;
};

FieldGaps gaps_in(const Geometry& geometry);

// The position of the camera with that id; nullopt if the message does not contain it, or if the
// position is below the carpet or more than 100 m away.
std::optional<CameraPosition> calibrated_camera(const Geometry& geometry, std::uint32_t id);

// The position of the camera with that id. If the message does not contain it, or its position is
// below the carpet or more than 100 m away, the camera is assumed to be above `below_m`.
CameraPosition camera_of(const Geometry& geometry, std::uint32_t id, const Vec2& below_m);

}  // namespace autoref::league
