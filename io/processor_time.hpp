// Processor time of processes.
#pragma once

#include <sys/resource.h>

namespace autoref::io {

// User and system time together, in s: Linux measures their sum exactly and only estimates how it
// is divided.
inline double processor_s(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Processor time that has been used so far by `whose` processes: RUSAGE_SELF, or RUSAGE_CHILDREN,
// which counts only children that have ended and been waited for.
inline double processor_s_of(int whose) {
  rusage usage{};
  getrusage(whose, &usage);
  return processor_s(usage);
}

}  // namespace autoref::io
