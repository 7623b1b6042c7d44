// Writes text as YAML.
#pragma once

#include <string>

namespace autoref::io {

// Returns `text` as a double-quoted scalar, which reads back unchanged, whatever characters the
// text contains.
std::string quoted_scalar(const std::string& text);

}  // namespace autoref::io
