#include "game/settings/command_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace autoref::game {
namespace {

bool is_plain(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
         std::string_view("_-+./,:=@%^").find(letter) != std::string_view::npos;
}

// Puts the word in single quotes if necessary; inside them, only a single quote needs escaping.
std::string quoted_word(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char letter : word) {
    if (letter == '\'') {
      quoted += R"('\'')";
    } else {
      quoted += letter;
    }
  }
  return quoted + "'";
}

class CommandReader {
 public:
  explicit CommandReader(std::string_view text) : text_(text) {}

  std::vector<std::string> words() {
    for (; !text_.empty(); text_.remove_prefix(1)) read(text_.front());
    if (quote_ != 0) throw std::invalid_argument(fmt::format("a quote ({}) is not closed", quote_));
    end_word();
    return std::move(words_);
  }

 private:
  void read(char letter) {
    if (letter == '\\' && quote_ != '\'' && text_.size() > 1) {
      text_.remove_prefix(1);
      add(text_.front());
    } else if (letter == quote_) {
      quote_ = 0;
    } else if (quote_ == 0 && (letter == '\'' || letter == '"')) {
      quote_ = letter;
      is_word_ = true;
    } else if (quote_ == 0 && std::isspace(static_cast<unsigned char>(letter)) != 0) {
      end_word();
    } else {
      add(letter);
    }
  }

  void add(char letter) {
    word_ += letter;
    is_word_ = true;
  }

  void end_word() {
    if (is_word_) words_.push_back(word_);
    word_.clear();
    is_word_ = false;
  }

  std::string_view text_;
  std::vector<std::string> words_;
  std::string word_;
  bool is_word_ = false;  // whether a word has begun, perhaps an empty one
  char quote_ = 0;        // 0: no quote is open
};

}  // namespace

std::vector<std::string> words_of_command(std::string_view text) {
  return CommandReader(text).words();
}

std::string text_of_command(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + quoted_word(word);
  return text;
}

}  // namespace autoref::game
