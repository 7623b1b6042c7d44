// Lets fuzz targets pass their input to readers of files.
#pragma once

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

// Writes the bytes to a file in memory and returns the path under which this process can open it.
inline std::string as_file(const std::uint8_t* data, std::size_t size) {
  static const int file = memfd_create("log", 0);
  if (ftruncate(file, 0) != 0) std::abort();
  if (pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  return fmt::format("/proc/self/fd/{}", file);
}
