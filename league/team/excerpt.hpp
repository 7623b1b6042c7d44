// Quoting of a program's output in messages.
#pragma once

#include <string>
#include <string_view>

namespace autoref::league {

// `bytes` in quotation marks, cut after 40 bytes; those that are not printable ASCII are written as
// \xHH.
std::string excerpt_of(std::string_view bytes);

}  // namespace autoref::league
