// What a user can set of a match's sequential test: for its reader and its writer.
#pragma once

#include <vector>

#include "runner/settings/fields.hpp"
#include "runner/statistics/sequential_test.hpp"

namespace autoref::runner {

// Each by its path, "sprt.d0" and so on.
std::vector<Setting> settings_of(SequentialTest& test);

// Throws SettingError where settings that are right alone make no test together.
void check_test(const SequentialTest& test);

}  // namespace autoref::runner
