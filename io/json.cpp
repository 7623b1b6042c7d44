#include "io/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace autoref::io {
namespace {

std::string number_text(double number) {
  return std::isfinite(number) ? fmt::format("{}", number) : "null";
}

std::string scalar_text(const Json& value) {
  if (value.is_number_float()) return number_text(value.get<double>());
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void append(const Json& value, std::string& text) {
  if (!value.is_structured()) {
    text += scalar_text(value);
    return;
  }
  text += value.is_object() ? '{' : '[';
  const std::size_t begin = text.size();
  for (const auto& member : value.items()) {
    if (text.size() > begin) text += ", ";
    if (value.is_object()) text.append(scalar_text(member.key())).append(": ");
    append(member.value(), text);
  }
  text += value.is_object() ? '}' : ']';
}

}  // namespace

std::string json_text(const Json& value) {
  std::string text;
  append(value, text);
  return text;
}

Json json_number(std::optional<double> number) { return number ? Json(*number) : Json(); }

double rounded(double number, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(number * scale) / scale;
}

}  // namespace autoref::io
