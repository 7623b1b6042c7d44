#include "live/network/source_lock.hpp"

namespace autoref::live {
namespace {

constexpr std::chrono::seconds kSilence{2};

}  // namespace

bool SourceLock::admits(const std::string& host, std::chrono::steady_clock::time_point now,
                        bool has_commands) {
  if (host != host_ && !host_.empty() && now - last_ < kSilence) return false;
  if (host != host_ && !has_commands) return true;
  host_ = host;
  last_ = now;
  return true;
}

}  // namespace autoref::live
