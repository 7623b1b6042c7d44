#include "league/followed_source.hpp"

#include <cmath>
#include <cstddef>

namespace autoref::league {
namespace {

constexpr double kSilence_s = 1;
constexpr std::size_t kMostSources = 64;
constexpr std::size_t kLongestSourceName = 64;  // bytes

}  // namespace

bool FollowedSource::follows(std::string_view name, double received_s) {
  name = name.substr(0, kLongestSourceName);
  const bool is_first = sources_.empty();
  if (sources_.size() < kMostSources) sources_.emplace(name);
  const bool is_other = is_first || name != name_;
  if (is_other && !is_first && std::abs(received_s - heard_s_) <= kSilence_s) {
    if (!has_ignored_) ignored_name_ = name;
    has_ignored_ = true;
    return false;
  }
  changes_ += is_other && !is_first ? 1 : 0;
  name_ = name;
  heard_s_ = received_s;
  return true;
}

}  // namespace autoref::league
