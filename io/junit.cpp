#include "io/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/json.hpp"

namespace autoref::io {
namespace {

constexpr const char* kReplacement = "\uFFFD";

// The text with U+FFFD in place of bytes that are not UTF-8.
std::string valid_utf8(std::string_view text) {
  return Json::parse(json_text(Json(text))).get<std::string>();
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20; }

// Of the characters below the space, XML allows tabs and line breaks only.
std::string control_text(char c) {
  if (c == '\t' || c == '\n') return std::string(1, c);
  return c == '\r' ? "&#13;" : kReplacement;
}

std::string character_text(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return is_control(c) ? control_text(c) : std::string(1, c);
  }
}

// XML does not allow U+FFFE and U+FFFF either.
std::string without_noncharacters(std::string text) {
  for (const std::string_view refused : {"\uFFFE", "\uFFFF"}) {
    for (std::size_t at = 0; (at = text.find(refused, at)) != std::string::npos;)
      text.replace(at, refused.size(), kReplacement);
  }
  return text;
}

std::string element_text(std::string_view text) {
  std::string escaped;
  for (const char c : without_noncharacters(valid_utf8(text))) escaped += character_text(c);
  return escaped;
}

// Parsers turn tabs and line breaks in attributes into spaces unless they are escaped.
std::string attribute_text(std::string_view text) {
  std::string escaped;
  for (const char c : element_text(text))
    escaped +=
        c == '\t' || c == '\n' ? fmt::format("&#{};", static_cast<int>(c)) : std::string(1, c);
  return escaped;
}

// The part of a case for a failure, an error or a text.
std::string outcome_text(const TestCase& test) {
  if (test.outcome == TestOutcome::kPassed) {
    if (test.text.empty()) return "";
    return fmt::format("    <system-out>{}</system-out>\n", element_text(test.text));
  }
  const char* const element = test.outcome == TestOutcome::kFailed ? "failure" : "error";
  return fmt::format("    <{0} message=\"{1}\">{2}</{0}>\n", element, attribute_text(test.message),
                     element_text(test.text));
}

std::string case_text(const TestCase& test) {
  return fmt::format("  <testcase classname=\"{}\" name=\"{}\">\n{}  </testcase>\n",
                     attribute_text(test.group), attribute_text(test.name), outcome_text(test));
}

auto count_of(const std::vector<TestCase>& cases, TestOutcome outcome) {
  return std::count_if(cases.begin(), cases.end(),
                       [outcome](const TestCase& test) { return test.outcome == outcome; });
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::vector<TestCase>& cases) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\">\n",
      attribute_text(suite), cases.size(), count_of(cases, TestOutcome::kFailed),
      count_of(cases, TestOutcome::kError));
  for (const TestCase& test : cases) text += case_text(test);
  return text + "</testsuite>\n</testsuites>\n";
}

}  // namespace autoref::io
