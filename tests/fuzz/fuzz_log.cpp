// Fuzzes the log reader with arbitrary bytes, compressed or not: framing, packets, frames.
#include <cstdint>

#include "league/log_contents.hpp"
#include "tests/fuzz/file_in_memory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  autoref::league::LogVisitor nobody;
  try {
    autoref::league::read_log(as_file(data, size), nobody);
  } catch (const autoref::league::LogError&) {  // not a log
  }
  return 0;
}
