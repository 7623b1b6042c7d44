// Files of the checkout that tests read.
#pragma once

#include <string>

namespace autoref {

// The absolute path of a file or folder of this checkout, given by its path from the root.
std::string in_checkout(const std::string& path);

}  // namespace autoref
