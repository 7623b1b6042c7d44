// Reads what happens in a case.
#pragma once

#include <vector>

#include "tests/referee/rules/case.hpp"
#include "tests/referee/rules/yaml_keys.hpp"

namespace autoref::referee {

// The cues under the key `script`, none where it is not given. Throws CaseError, also for cues that
// are not in the order of time.
std::vector<Cue> read_script(YamlKeys& keys);

}  // namespace autoref::referee
