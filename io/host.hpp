// The machine the program runs on.
#pragma once

#include <string>

namespace autoref::io {

// The machine's network name, or "unknown".
std::string host_name();

// The processor's model name as Linux reports it; "unknown" on other systems.
std::string cpu_name();

}  // namespace autoref::io
