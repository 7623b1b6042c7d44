// Parsing of protobuf messages that may be malformed.
#pragma once

#include <string_view>

namespace autoref::league {

// Returns whether `bytes` are a complete message. Partial parsing keeps protobuf from printing its
// own messages to stderr.
template <typename Message>
bool parse(std::string_view bytes, Message& message) {
  return message.ParsePartialFromArray(bytes.data(), static_cast<int>(bytes.size())) &&
         message.IsInitialized();
}

}  // namespace autoref::league
