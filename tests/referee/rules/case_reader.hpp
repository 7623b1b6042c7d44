// Reads the cases of cases/*.yaml.
#pragma once

#include <string>
#include <vector>

#include "tests/referee/rules/case.hpp"

namespace autoref::referee {

// The cases of every file of the folder, ordered by file name. What is wrong with a case stands in
// its `error`; a file that cannot be read at all becomes one such case.
std::vector<Case> read_cases(const std::string& folder);

// The cases of one file's text, for tests of the reader.
std::vector<Case> cases_in(const std::string& text, const std::string& file);

}  // namespace autoref::referee
