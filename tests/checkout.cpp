#include "tests/checkout.hpp"

namespace autoref {

std::string in_checkout(const std::string& path) {
  const std::string root = AUTOREF_SOURCE_DIR;
  return root + '/' + path;
}

}  // namespace autoref
