// Which sources this program was built from.
#pragma once

#include <string_view>

namespace autoref::runner {

// "0.1.0-" and 12 digits: the SHA-256 over every source of the folders that decide games. Equal
// for all compilers and presets; a change of documents, tests or scenarios does not change it.
std::string_view build_id();

}  // namespace autoref::runner
