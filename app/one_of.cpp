#include "app/one_of.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "io/words.hpp"

namespace autoref::app {

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto fault = [words](const std::string& word) -> std::string {
    if (std::find(words.begin(), words.end(), word) != words.end()) return {};
    return fmt::format("expected one of {}, found '{}'{}", io::listed(words), word,
                       io::suggestion(word, words));
  };
  return {fault, fmt::format("{{{}}}", fmt::join(words, ","))};
}

std::vector<std::string> words_in_type(const std::string& type_name) {
  const std::size_t brace = type_name.find(":{");
  const bool is_checked = brace != std::string::npos && type_name.ends_with('}');
  if (!is_checked && type_name.find('|') == std::string::npos) return {};
  std::istringstream list(is_checked ? type_name.substr(brace + 2, type_name.size() - brace - 3)
                                     : type_name);
  std::vector<std::string> words;
  for (std::string word; std::getline(list, word, is_checked ? ',' : '|');)
    if (io::lower_case(word) == word) words.push_back(word);
  return words;
}

}  // namespace autoref::app
