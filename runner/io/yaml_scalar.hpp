// Text as YAML.
#pragma once

#include <string>

namespace autoref::runner {

// `text` as a double-quoted scalar, which reads back unchanged, whatever characters it contains.
std::string quoted_scalar(const std::string& text);

}  // namespace autoref::runner
