// Ends the test program if a test hangs.
#pragma once

#include <unistd.h>

namespace autoref {

class TimeLimit {
 public:
  explicit TimeLimit(unsigned seconds = 120) { alarm(seconds); }
  ~TimeLimit() { alarm(0); }
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
};

}  // namespace autoref
