// Identifies the sources this program was built from.
#pragma once

#include <string_view>

namespace autoref::io {

// "1.0.0-" and 12 hexadecimal digits of the SHA-256 of all sources that can affect a game. It is
// the same for all compilers and presets, and does not depend on documents, tests or scenarios.
std::string_view build_id();

}  // namespace autoref::io
