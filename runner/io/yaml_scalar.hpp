// Text as YAML.
#pragma once

#include <string>

namespace autoref::runner {

// `text` as a double-quoted scalar, which reads back equal whatever it holds.
std::string quoted_scalar(const std::string& text);

}  // namespace autoref::runner
