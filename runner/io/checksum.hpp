// Hashes and checksums as text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace autoref::runner {

// Formats the hash as 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

// CRC-32 of the text (as computed by zlib), as 8 hexadecimal digits.
std::string crc_text(std::string_view text);

}  // namespace autoref::runner
