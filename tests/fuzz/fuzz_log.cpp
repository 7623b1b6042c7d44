// Fuzzes the log reader with arbitrary bytes, compressed or not: framing, packets, frames.
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#include "league/log_contents.hpp"

namespace {

// Writes the bytes to a file in memory and returns the path under which this process can open it.
std::string as_file(const std::uint8_t* data, std::size_t size) {
  static const int file = memfd_create("log", 0);
  if (ftruncate(file, 0) != 0) std::abort();
  if (pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  return fmt::format("/proc/self/fd/{}", file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  autoref::league::LogVisitor nobody;
  try {
    autoref::league::read_log(as_file(data, size), nobody);
  } catch (const autoref::league::LogError&) {  // not a log
  }
  return 0;
}
