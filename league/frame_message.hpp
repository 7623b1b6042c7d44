// A frame of the field as the league's cameras report it: each its part.
#pragma once

#include <span>

#include "league/messages/vision.pb.h"
#include "soccer/frame.hpp"

namespace autoref::league {

// Fills `packets` with what each of `cameras` sees of the frame: a robot or ball belongs to the
// nearest camera, a ball whose height vision does not know to the one that saw it. West is yellow.
// As many packets as cameras; nothing is allocated once they have been as full before.
void fill_detections(const Frame& frame, std::span<const CameraPosition> cameras,
                     std::span<VisionPacket> packets);

}  // namespace autoref::league
