#include "runner/io/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace autoref::runner {
namespace {

template <typename Number>
std::optional<Number> parsed(std::string_view text) {
  // from_chars() accepts a minus sign but not a plus sign.
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// Levenshtein distance, computed one table row at a time.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t exchanged = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, exchanged});
    }
  }
  return row.back();
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
  const std::optional<double> number = parsed<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<int> whole_number_in(std::string_view text) { return parsed<int>(text); }

std::optional<std::uint64_t> seed_in(std::string_view text) { return parsed<std::uint64_t>(text); }

std::optional<std::uint64_t> hexadecimal_in(std::string_view text) {
  constexpr int kBase = 16;
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, kBase);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string text_of(double number) {
  std::string text = fmt::format("{}", number);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& words) {
  const auto nearest = std::min_element(
      words.begin(), words.end(), [word](const std::string& left, const std::string& right) {
        return edit_distance(word, left) < edit_distance(word, right);
      });
  return nearest == words.end() ? std::string() : *nearest;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& words) {
  const std::string nearest = nearest_word(word, words);
  // Accept prefixes, and words with at most every other letter wrong.
  const bool is_begun = !word.empty() && nearest.starts_with(word);
  if (!is_begun && 2 * edit_distance(word, nearest) > nearest.size()) return {};
  return fmt::format("; did you mean '{}'?", nearest);
}

std::string printable(std::string_view name) {
  constexpr std::size_t kLongest = 64;
  std::string text(name.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return text;
}

std::string listed(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace autoref::runner
