// Functions shared by senders of tracker packets.
#pragma once

#include <string>

#include "soccer/tracks.hpp"

namespace autoref::live {

// The tracks converted to the field's coordinates if these differ from the program's coordinates
// (referee_signal.hpp).
Tracks turned(Tracks tracks);

// A random UUID of version 4.
std::string random_uuid();

}  // namespace autoref::live
