#include "soccer/parameters.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace autoref {
namespace {

// In this list, an ending comes before any other ending with which it ends.
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kUnits = {{
    {"_per_m", "1/m"},
    {"_per_s", "1/s"},
    {"_hz", "1/s"},
    {"_radps2", "rad/s^2"},
    {"_radps", "rad/s"},
    {"_rad", "rad"},
    {"_deg", "deg"},
    {"_mps2", "m/s^2"},
    {"_mps", "m/s"},
    {"_nspm", "N s/m"},
    {"_npm", "N/m"},
    {"_n", "N"},
    {"_kg", "kg"},
    {"_mb", "MB"},
    {"_m", "m"},
    {"_s", "s"},
}};

// An ending of the name and its unit; both are empty if the name has no unit.
std::pair<std::string_view, std::string_view> unit_at_end_of(std::string_view name) {
  for (const auto& one : kUnits)
    if (name.ends_with(one.first)) return one;
  return {};
}

}  // namespace

std::string text_of(const Range& range, std::string_view unit) {
  const std::string_view space = unit.empty() ? "" : " ";
  return fmt::format(
      fmt::runtime(range.above_low ? "above {} and at most {}{}{}" : "from {} to {}{}{}"),
      range.low, range.high, space, unit);
}

std::string_view unit_of(std::string_view name) { return unit_at_end_of(name).second; }

std::string_view without_unit(std::string_view name) {
  return name.substr(0, name.size() - unit_at_end_of(name).first.size());
}

void refuse_value(const std::string& path, double value, const std::string& allowed) {
  throw OutOfRange(path, fmt::format(" is {}; it must be {}", value, allowed));
}

void check_number(const std::string& path, double value, const Range& range) {
  if (!range.contains(value)) refuse_value(path, value, text_of(range));
}

}  // namespace autoref
