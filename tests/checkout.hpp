// Files of the checkout that tests read.
#pragma once

#include <string>

namespace autoref {

// The absolute path of a file or folder of this checkout, given from its root.
std::string in_checkout(const std::string& path);

}  // namespace autoref
