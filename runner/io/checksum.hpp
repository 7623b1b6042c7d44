// Hashes and checksums as text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace autoref::runner {

// 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

// The CRC-32 of the text (as zlib computes it), 8 hexadecimal digits.
std::string crc_text(std::string_view text);

}  // namespace autoref::runner
