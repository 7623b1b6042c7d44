// The program's verbs and options as data: used for the man page, the reference page and
// completion.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace autoref::app {

struct DescribedOption {
  std::vector<std::string> names;  // "-o", "--output"; an argument has one name
  std::string value;               // what help calls the value, such as "FILE"; empty for a flag
  std::string description;
  bool is_positional = false;
  std::vector<std::string> allowed_words = {};  // the words that the help lists, if any
};

// The program itself, a group of verbs, or a verb.
struct DescribedVerb {
  std::string name;
  std::string description;
  std::vector<DescribedOption> options;
  std::string footer;                // examples and notes
  std::vector<DescribedVerb> verbs;  // in the order in which the help lists them
};

// Everything that `autoref --help` and `autoref VERB --help` print.
DescribedVerb described(const CLI::App& app);

// The man page autoref(1), as roff source. `version` is what --version prints.
std::string man_page(const DescribedVerb& program, const std::string& version);

}  // namespace autoref::app
