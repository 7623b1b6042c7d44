#include "league/team/json_text.hpp"

#include <array>
#include <charconv>

namespace autoref::league {
namespace {

// `value` without a point or exponent if it is a whole number.
template <typename Number>
std::string_view digits_of(Number value, std::array<char, 32>& buffer) {
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), static_cast<std::size_t>(end - buffer.data())};
}

}  // namespace

void JsonText::begin(std::string_view name) {
  if (!is_first_) *text_ += ',';
  is_first_ = false;
  if (name.empty()) return;
  *text_ += '"';
  *text_ += name;
  *text_ += "\":";
}

JsonText& JsonText::open(char bracket, std::string_view name) {
  begin(name);
  *text_ += bracket;
  is_first_ = true;
  return *this;
}

JsonText& JsonText::close(char bracket) {
  *text_ += bracket;
  is_first_ = false;
  return *this;
}

JsonText& JsonText::member(std::string_view name, double value) {
  begin(name);
  std::array<char, 32> buffer{};
  const std::string_view digits = digits_of(value, buffer);
  *text_ += digits;
  if (digits.find_first_of(".e") == std::string_view::npos) *text_ += ".0";
  return *this;
}

JsonText& JsonText::member(std::string_view name, std::int64_t value) {
  begin(name);
  std::array<char, 32> buffer{};
  *text_ += digits_of(value, buffer);
  return *this;
}

JsonText& JsonText::member(std::string_view name, bool value) {
  begin(name);
  *text_ += value ? "true" : "false";
  return *this;
}

JsonText& JsonText::member(std::string_view name, std::string_view value) {
  begin(name);
  *text_ += '"';
  *text_ += value;
  *text_ += '"';
  return *this;
}

JsonText& JsonText::null(std::string_view name) {
  begin(name);
  *text_ += "null";
  return *this;
}

}  // namespace autoref::league
