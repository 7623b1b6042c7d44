// Reads the cases of cases/*.yaml.
#pragma once

#include <string>
#include <vector>

#include "tests/referee/rules/case.hpp"

namespace autoref::referee {

// The cases of every file in the folder, ordered by file name. Errors of a case are in its `error`;
// an unreadable file becomes one case with an error.
std::vector<Case> read_cases(const std::string& folder);

// The cases in one file's text, for tests of the reader.
std::vector<Case> cases_in(const std::string& text, const std::string& file);

}  // namespace autoref::referee
