#include "io/checksum.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

#include "soccer/random.hpp"

namespace autoref::io {

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::string crc_text(std::string_view text) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  return fmt::format("{:08x}", crc.checksum());
}

void ByteHash::add(std::string_view bytes) {
  for (const char byte : bytes)
    hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
}

std::uint64_t ByteHash::value() const { return mix_bits(hash_); }

}  // namespace autoref::io
