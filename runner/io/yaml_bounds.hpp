// What a YAML text may cost its readers: whoever walks a document afterwards walks a bounded one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace autoref::runner {

struct YamlBounds {
  std::size_t bytes = std::size_t{4} << 20;
  std::size_t scalar_bytes = std::size_t{64} << 10;  // of one word or text
  std::int64_t nodes = 200'000;  // with each alias counted as all that it stands for
  std::size_t depth = 32;        // of lists and mappings in each other
};

// Where a text goes beyond its bounds, and what to do. Line and column count from 1.
struct BeyondBounds {
  int line = 0;
  int column = 0;
  std::string message;
};

// Looks at the text event by event and builds nothing, so that a text which would unfold without
// end costs no more than its bytes. None where all of it is within bounds. Throws YAML::Exception
// where the text is invalid YAML before it goes beyond them.
std::optional<BeyondBounds> beyond_bounds(const std::string& text, const YamlBounds& bounds = {});

}  // namespace autoref::runner
