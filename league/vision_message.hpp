// Splits a frame of the field into the packets of the league's cameras, and converts packets in the
// format of 2010.
#pragma once

#include <span>

#include "league/messages/vision.pb.h"
#include "soccer/frame.hpp"

namespace autoref::league {

// The league's number for vision senders that are not in its list.
inline constexpr int kOtherSource = 1;

// Fills `packets` with the part of the frame that each of `cameras` sees: a robot or ball belongs
// to the nearest camera, but a ball of unknown height to the camera that saw it. West is yellow.
// The detections in `others` follow those in the frame and have a lower confidence. Writes one
// packet per camera. Allocates nothing once the packets are large enough.
void fill_detections(const Frame& frame, std::span<const CameraPosition> cameras,
                     std::span<VisionPacket> packets, const OtherDetections& others = {});

// Moves the contents of `old`, which has the format of logs until 2014, into a packet of the
// current format. The field's dimensions, its quarter-circle defence areas and its margin (boundary
// and referee's runway) are preserved.
void convert(VisionPacket2010& old, VisionPacket& packet);

}  // namespace autoref::league
