// Strict reading of numbers, and suggestions for mistyped words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::runner {

// The number that the whole of `text` spells, none where it spells none. Decimal, with a point
// whatever the locale, and finite: "0.5", "-2", "1e-3", not "0x10", "inf", "1,5" or "1 ".
std::optional<double> number_in(std::string_view text);

// Whole numbers, without point and exponent.
std::optional<int> whole_number_in(std::string_view text);
std::optional<std::uint64_t> seed_in(std::string_view text);

// The shortest text that reads back as the same number; always with a point or an exponent.
std::string text_of(double number);

// The word that takes the fewest letters inserted, removed or exchanged to reach; the first of
// several. Empty where there are no words.
std::string nearest_word(std::string_view word, const std::vector<std::string>& words);

// "; did you mean 'robots'?" for a word that is close to one of the words; empty where none is.
std::string suggestion(std::string_view word, const std::vector<std::string>& words);

// "a, b, c".
std::string listed(const std::vector<std::string>& words);

}  // namespace autoref::runner
