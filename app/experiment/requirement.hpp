// What `autoref compare --require` demands of the new team.
#pragma once

#include <string>
#include <vector>

#include "experiments/statistics/sequential_test.hpp"

namespace autoref::app {

struct Requirement {
  const char* word;       // value of --require
  const char* statement;  // "new is better than old"
  bool (*is_met)(experiments::ThreeWayVerdict verdict);
};

inline constexpr const char* kDefaultRequirement = "not-worse";

// The values of --require, from the weakest to the strongest.
std::vector<std::string> requirement_words();

// Throws std::logic_error for any other word.
const Requirement& requirement_of(const std::string& word);

}  // namespace autoref::app
