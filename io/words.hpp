// Strict reading of numbers, and suggestions for mistyped words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::io {

// Parses the whole of `text` as a finite decimal number; nullopt otherwise. The decimal separator
// is a point in every locale: "0.5", "-2", "1e-3", but not "0x10", "inf", "1,5" or "1 ".
std::optional<double> number_in(std::string_view text);

// Parses a whole number, without point or exponent.
std::optional<int> whole_number_in(std::string_view text);
std::optional<std::uint64_t> seed_in(std::string_view text);

// Parses a whole number in hexadecimal digits, without prefix or sign: "1c9f03ae".
std::optional<std::uint64_t> hexadecimal_in(std::string_view text);

// Shortest text that reads back as the same number, always with a point or an exponent.
std::string text_of(double number);

// Returns the known word with the smallest edit distance, or the first of them if several are
// equally close. Empty if `words` is empty.
std::string nearest_word(std::string_view word, const std::vector<std::string>& words);

// The known words that may have been meant, at most three, in the order of `words`: those that
// begin with `word` (only those with a single additional letter, if there are any), otherwise the
// nearest one if it is close.
std::vector<std::string> suggested_words(std::string_view word,
                                         const std::vector<std::string>& words);

// "; did you mean 'robots'?" for words that may have been meant, such as the result of
// suggested_words(); empty if there are none.
std::string suggestion_text(const std::vector<std::string>& words);

// suggestion_text() of the suggested words.
std::string suggestion(std::string_view word, const std::vector<std::string>& words);

// A name from outside, made safe for display: at most 64 bytes, with question marks for anything
// but printable ASCII.
std::string printable(std::string_view name);

// The text without spaces and tabs at either end.
std::string_view trimmed(std::string_view text);

// The text with 'a' to 'z' in place of 'A' to 'Z'.
std::string lower_case(std::string text);

// "a, b, c".
std::string listed(const std::vector<std::string>& words);

}  // namespace autoref::io
