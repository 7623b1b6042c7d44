// Hashes and checksums as text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace autoref::io {

// Formats the hash as 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

// A hash of bytes that is the same on all machines and in all builds: FNV-1a, followed by a bit
// mixer.
class ByteHash {
 public:
  void add(std::string_view bytes);
  std::uint64_t value() const;

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

// CRC-32 of the text (as computed by zlib), as 8 hexadecimal digits.
std::string crc_text(std::string_view text);

}  // namespace autoref::io
