// Base64 encoding (RFC 4648, section 4).
#pragma once

#include <string>
#include <string_view>

namespace autoref::view {

std::string base64_of(std::string_view bytes);

}  // namespace autoref::view
