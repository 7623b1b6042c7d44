#include "io/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

namespace autoref::io {
namespace {

constexpr std::size_t kMostSuggested = 3;

template <typename Number>
std::optional<Number> parsed(std::string_view text) {
  // from_chars() accepts a minus sign but not a plus sign.
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// Levenshtein distance in which two swapped neighbours count as one mistake (optimal string
// alignment), computed one table row at a time.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  std::vector<std::size_t> last = row;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::vector<std::size_t> before_last = std::exchange(last, row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = last[j] + (from[i] == to[j] ? 0 : 1);
      row[j + 1] = std::min({last[j + 1] + 1, row[j] + 1, replaced});
      const bool is_exchanged = i > 0 && j > 0 && from[i] == to[j - 1] && from[i - 1] == to[j];
      if (is_exchanged) row[j + 1] = std::min(row[j + 1], before_last[j - 1] + 1);
    }
  }
  return row.back();
}

// Up to kMostSuggested words that begin with `word` and have at most `most` additional letters.
std::vector<std::string> words_longer_by(std::string_view word, std::size_t most,
                                         const std::vector<std::string>& words) {
  std::vector<std::string> longer;
  for (const std::string& one : words) {
    const bool is_new = std::find(longer.begin(), longer.end(), one) == longer.end();
    const bool is_begun = one.starts_with(word) && one.size() - word.size() <= most;
    if (longer.size() < kMostSuggested && is_begun && is_new) longer.push_back(one);
  }
  return longer;
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

std::vector<std::string> suggested_words(std::string_view word,
                                         const std::vector<std::string>& words) {
  if (word.empty() || words.empty()) return {};
  std::vector<std::string> begun = words_longer_by(word, 1, words);
  if (begun.empty()) begun = words_longer_by(word, std::string::npos, words);
  if (!begun.empty()) return begun;
  // Accept words with at most every other letter wrong.
  std::string nearest = nearest_word(word, words);
  if (2 * edit_distance(word, nearest) > nearest.size()) return {};
  return {std::move(nearest)};
}

std::string suggestion_text(const std::vector<std::string>& words) {
  if (words.empty()) return {};
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_last = i + 1 == words.size();
    text += fmt::format("{}'{}'", i == 0 ? "" : is_last ? " or " : ", ", words[i]);
  }
  return fmt::format("; did you mean {}?", text);
}

std::string suggestion(std::string_view word, const std::vector<std::string>& words) {
  return suggestion_text(suggested_words(word, words));
}

std::string printable(std::string_view name) {
  constexpr std::size_t kLongest = 64;
  std::string text(name.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
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

}  // namespace autoref::io
