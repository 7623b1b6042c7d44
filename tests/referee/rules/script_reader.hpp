// Reads the script of a case.
#pragma once

#include <vector>

#include "tests/referee/rules/case.hpp"
#include "tests/referee/rules/yaml_keys.hpp"

namespace autoref::referee {

// The cues under the key `script`; empty if the key is missing. Throws CaseError for invalid cues
// and for cues out of order.
std::vector<Cue> read_script(YamlKeys& keys);

}  // namespace autoref::referee
