// Printing of JSON values. Sources that create values include <nlohmann/json.hpp>; this header does
// not, because the library is slow to compile.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace autoref::io {

// Members keep their insertion order.
using Json = nlohmann::ordered_json;

// Formats `value` on one line, with a space after each comma and colon. A number gets the shortest
// text that reads back equal (2 rather than 2.0), or null if it is not finite. Bytes that are not
// UTF-8 become U+FFFD.
std::string json_text(const Json& value);

// The number, or null if it is missing.
Json json_number(std::optional<double> number);

// Rounds `number` to `decimals` decimal places, for shorter JSON.
double rounded(double number, int decimals);

}  // namespace autoref::io
