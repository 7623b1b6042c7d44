#include "league/team/greeting.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

constexpr std::size_t kLongestGreeting = 80;  // bytes, without the end of the line
constexpr std::string_view kGreetingName = "autoref-team";
constexpr std::string_view kGreetingVersion = "1";

// The list of names as text: "json, flat or league".
template <typename Enumeration>
std::string alternatives() {
  std::vector<std::string> names = all_names<Enumeration>();
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} or {}", fmt::join(names, ", "), last);
}

std::string greeting_usage() {
  return fmt::format(
      "expected \"autoref-team 1 ENCODING [MOTION]\", with ENCODING {} and MOTION {}",
      alternatives<TeamEncoding>(), alternatives<TeamMotion>());
}

// Splits at single spaces.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t space = 0; space != std::string_view::npos;) {
    space = line.find(' ');
    words.push_back(line.substr(0, space));
    if (space != std::string_view::npos) line.remove_prefix(space + 1);
  }
  return words;
}

[[noreturn]] void refuse(std::string_view line, std::string_view why) {
  throw TeamFault(
      fmt::format("the first line is {}: {}; {}", excerpt_of(line), why, greeting_usage()));
}

template <typename Enumeration>
Enumeration named_in(std::string_view line, std::string_view word, std::string_view what) {
  const std::optional<Enumeration> value = find_named<Enumeration>(word);
  if (!value) refuse(line, fmt::format("unknown {} {}", what, excerpt_of(word)));
  return *value;
}

}  // namespace

Greeting greeting_of(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  if (words[0] != kGreetingName) refuse(line, "it is not a greeting");
  if (words.size() < 2) refuse(line, "the version is missing");
  if (words[1] != kGreetingVersion)
    refuse(line, fmt::format("unknown version {}", excerpt_of(words[1])));
  if (words.size() < 3) refuse(line, "the encoding is missing");
  Greeting greeting;
  greeting.encoding = named_in<TeamEncoding>(line, words[2], "encoding");
  if (greeting.encoding == TeamEncoding::kLeague) greeting.motion = TeamMotion::kDetections;
  if (words.size() > 3) greeting.motion = named_in<TeamMotion>(line, words[3], "motion");
  if (words.size() > 4) refuse(line, "it has too many words");
  return greeting;
}

std::optional<GreetingAndSize> find_greeting(std::string_view bytes) {
  const std::string_view beginning = bytes.substr(0, kLongestGreeting + 1);
  const std::size_t end = beginning.find('\n');
  if (end != std::string_view::npos) {
    return GreetingAndSize{greeting_of(beginning.substr(0, end)), end + 1};
  }
  if (bytes.size() > kLongestGreeting) {
    throw TeamFault(
        fmt::format("the first line begins with {} and does not end within {} bytes; {}",
                    excerpt_of(beginning), kLongestGreeting, greeting_usage()));
  }
  return std::nullopt;
}

}  // namespace autoref::league
