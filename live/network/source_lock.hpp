// Decides whose packets count when several computers send to one port.
#pragma once

#include <chrono>
#include <string>

namespace autoref::live {

// Admits packets from one computer: the first computer that sends commands, until it has been
// silent for 2 s.
class SourceLock {
 public:
  // A packet without commands is admitted unless another computer is in command, but does not lock
  // out others.
  bool admits(const std::string& host, std::chrono::steady_clock::time_point now,
              bool has_commands = true);

  const std::string& host() const { return host_; }  // empty if no computer has sent commands yet

 private:
  std::string host_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace autoref::live
