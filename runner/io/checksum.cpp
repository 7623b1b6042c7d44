#include "runner/io/checksum.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

namespace autoref::runner {

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::string crc_text(std::string_view text) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  return fmt::format("{:08x}", crc.checksum());
}

}  // namespace autoref::runner
