// How AutoRef prints JSON. nlohmann-json holds the values; sources that make them include
// <nlohmann/json.hpp>, which takes long to compile.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace autoref::runner {

// Members keep the order in which they are added.
using Json = nlohmann::ordered_json;

// `value` on one line, with a space after each comma and colon. A number gets the shortest text
// that reads back equal (2 rather than 2.0), or null if it is not finite. Bytes that are not UTF-8
// become U+FFFD.
std::string json_text(const Json& value);

// `number` to that many decimals: JSON shows no more of it.
double rounded(double number, int decimals);

}  // namespace autoref::runner
