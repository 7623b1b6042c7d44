// The field as vision describes it.
#pragma once

#include <span>

#include "league/messages/vision.pb.h"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::league {

// Fills `geometry` with field and cameras; a camera's id is its place in `cameras`. The lines have
// the names that the league's vision gives them.
void fill_geometry(const Field& field, std::span<const CameraPosition> cameras, Geometry& geometry);

// The field of a message. What messages do not tell, such as the goals' walls, has Field's
// defaults. Throws std::invalid_argument where a length is not positive (a margin of 0 is one) or
// beyond 100 m.
Field field_of(const Geometry& geometry);

// What a message may leave out, and whether it does.
struct FieldGaps {
  bool penalty_mark = false;
  bool defence_area = false;
};

FieldGaps gaps_in(const Geometry& geometry);

// Where the camera of that id hangs; above `below_m` where the message does not tell.
CameraPosition camera_of(const Geometry& geometry, std::uint32_t id, const Vec2& below_m);

}  // namespace autoref::league
