#include "app/former_names.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace autoref::app {
namespace {

using Words = std::vector<std::string>;

bool has_option(const Words& words, const std::string& option) {
  return std::any_of(words.begin(), words.end(), [&option](const std::string& word) {
    return word == option || word.starts_with(option + "=");
  });
}

// The name that replaces the first word; empty if that is not a former name.
std::string_view present_name_of(const Words& words) {
  // `draw` used to draw situations too.
  if (words.front() == "draw" && has_option(words, "--situation")) return "show situation";
  for (const FormerName& name : former_names())
    if (name.former == words.front()) return name.present;
  return {};
}

// Returns whether the word cannot be meant as a verb because it is a file or an option other than a
// group's.
bool is_option_or_file(const std::string& word) {
  if (word == "-h" || word == "--help") return false;
  std::error_code none;  // a name that cannot be looked up is not a file
  return word.starts_with('-') || word.find_first_of("./") != std::string::npos ||
         std::filesystem::exists(word, none);
}

// `referee` used to take a log or the flag --live instead of having verbs.
Words with_verb_of_referee(Words words) {
  const bool has_verb = words[1] == "log" || words[1] == "live";
  if (has_verb || !is_option_or_file(words[1])) return words;
  const bool is_live = std::erase(words, "--live") > 0;
  words.insert(words.begin() + 1, is_live ? "live" : "log");
  return words;
}

}  // namespace

const std::vector<FormerName>& former_names() {
  static const std::vector<FormerName> kNames = {{"status", "results status"},
                                                 {"verify", "results verify"},
                                                 {"replay", "results replay"},
                                                 {"export", "results export"},
                                                 {"info", "log info"},
                                                 {"draw", "log draw"},
                                                 {"tune", "run"},
                                                 {"submit", "experiment submit"},
                                                 {"sample-size", "experiment sample-size"},
                                                 {"lab", "experiment lab"},
                                                 {"rules", "show rules"},
                                                 {"teams", "show teams"},
                                                 {"bench", "show speed"},
                                                 {"man", "show man"},
                                                 {"completion", "show completion"}};
  return kNames;
}

Words with_present_names(Words words) {
  if (words.empty()) return words;
  if (words.front() == "help") {
    Words explained = with_present_names({words.begin() + 1, words.end()});
    explained.insert(explained.begin(), "help");
    return explained;
  }
  if (words.front() == "referee" && words.size() > 1) return with_verb_of_referee(std::move(words));
  const std::string_view present = present_name_of(words);
  if (present.empty()) return words;
  std::istringstream names{std::string(present)};
  Words replaced;
  for (std::string name; names >> name;) replaced.push_back(name);
  replaced.insert(replaced.end(), words.begin() + 1, words.end());
  return replaced;
}

}  // namespace autoref::app
