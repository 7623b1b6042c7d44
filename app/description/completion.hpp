// What may follow on a command line, for completion in shells.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/description/described_verb.hpp"

namespace autoref::app {

struct Proposal {
  std::string word;   // instead of the last word; more may follow if it ends with '.' or '='
  std::string about;  // may be empty
};

// What may stand for the last of `words`, the words after the program's name: verbs, options, or
// values, as far as they are known. At most 200; empty where any file may be meant.
std::vector<Proposal> proposals_for(const DescribedVerb& program,
                                    const std::vector<std::string>& words);

// A value that is completed.
struct ValuePlace {
  std::string kind;                      // as in help: "BOOK", "KEY=VALUE", "GAME_ID"
  std::string begun;                     // what is typed of it
  std::vector<std::string> positionals;  // the arguments without dashes before it
};

// Values of that kind that begin so; empty for an unknown kind.
std::vector<Proposal> values_at(const ValuePlace& place);

// Ids of games that have rows in a results folder and begin so, sorted. At most 200, and only those
// in the first megabytes of its files.
std::vector<std::string> stored_ids(const std::filesystem::path& folder, const std::string& begun);

// Prints the proposals for `autoref complete WORD ...`, one a line: the word, a tab, the
// description.
int complete_verb(const DescribedVerb& program, const std::vector<std::string>& words);

}  // namespace autoref::app
