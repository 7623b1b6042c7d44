// Writes text as a YAML scalar, and checks that YAML input is within size limits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace autoref::io {

// Returns `text` as a double-quoted scalar, which reads back unchanged regardless of the characters
// in the text.
std::string quoted_scalar(const std::string& text);

// Limits on the size of a YAML document once its aliases are expanded.
struct YamlBounds {
  std::size_t bytes = std::size_t{4} << 20;
  std::size_t scalar_bytes = std::size_t{64} << 10;  // maximum size of a single scalar
  std::int64_t nodes = 200'000;  // an alias counts as all the nodes to which it expands
  std::size_t depth = 32;        // nesting depth of lists and mappings
};

// The place where a text exceeds its bounds, and the remedy. Line and column count from 1.
struct BeyondBounds {
  int line = 0;
  int column = 0;
  std::string message;
};

// Scans the text event by event without building a tree, so the cost depends only on the text's
// length, not on the size to which its aliases would expand. Returns nullopt if the whole text is
// within bounds. Throws YAML::Exception if the text is invalid YAML before it exceeds them.
std::optional<BeyondBounds> beyond_bounds(const std::string& text, const YamlBounds& bounds = {});

}  // namespace autoref::io
