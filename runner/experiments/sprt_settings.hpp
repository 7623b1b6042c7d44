// The settings of an SPRT match's sequential test, for reading and writing.
#pragma once

#include <vector>

#include "runner/settings/fields.hpp"
#include "runner/statistics/sequential_test.hpp"

namespace autoref::runner {

// Paths are "sprt.d0" and so on.
std::vector<Setting> settings_of(SequentialTest& test);

// Throws SettingError if individually valid settings contradict each other.
void check_test(const SequentialTest& test);

}  // namespace autoref::runner
