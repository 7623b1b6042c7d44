// The machine that the program runs on.
#pragma once

#include <string>

namespace autoref::runner {

// Its network name; "unknown" where it has none.
std::string host_name();

// The processor's model name, as Linux reports it; "unknown" elsewhere.
std::string cpu_name();

}  // namespace autoref::runner
