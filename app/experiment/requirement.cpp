#include "app/experiment/requirement.hpp"

#include <array>
#include <stdexcept>

namespace autoref::app {
namespace {

using experiments::ThreeWayVerdict;

bool is_not_worse(ThreeWayVerdict verdict) { return verdict != ThreeWayVerdict::kWorse; }
bool is_equal_or_better(ThreeWayVerdict verdict) {
  return verdict == ThreeWayVerdict::kBetter || verdict == ThreeWayVerdict::kNotShown;
}
bool is_better(ThreeWayVerdict verdict) { return verdict == ThreeWayVerdict::kBetter; }

constexpr std::array<Requirement, 3> kRequirements = {{
    {kDefaultRequirement, "new is not shown to be worse than old", is_not_worse},
    {"equal", "new is better than old, or no difference matters", is_equal_or_better},
    {"better", "new is better than old", is_better},
}};

}  // namespace

std::vector<std::string> requirement_words() {
  std::vector<std::string> words;
  words.reserve(kRequirements.size());
  for (const Requirement& requirement : kRequirements) words.emplace_back(requirement.word);
  return words;
}

const Requirement& requirement_of(const std::string& word) {
  for (const Requirement& requirement : kRequirements)
    if (word == requirement.word) return requirement;
  throw std::logic_error("unknown requirement " + word);
}

}  // namespace autoref::app
