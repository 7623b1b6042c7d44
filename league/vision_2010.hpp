// The vision messages of 2010, which logs contain until 2014.
#pragma once

#include "league/messages/vision.pb.h"

namespace autoref::league {

// Moves the contents of `old` into a packet of today. The field's sizes, its defence areas of
// quarter circles and its margin (boundary and referee's runway) are preserved.
void convert(VisionPacket2010& old, VisionPacket& packet);

}  // namespace autoref::league
