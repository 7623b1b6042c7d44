// Whether a text contains another.
#pragma once

#include <string>

namespace autoref {

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace autoref
