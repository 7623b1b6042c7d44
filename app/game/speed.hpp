// The flag --speed.
#pragma once

#include <string>
#include <string_view>

namespace autoref::app {

// The factor of real time in `text`, from 0.01 to 1000. Throws InputError otherwise, which also
// names the other values that --speed takes, such as "max or lockstep".
double speed_factor_in(const std::string& text, std::string_view others);

}  // namespace autoref::app
