// Proposes how a command line can continue, for completion in shells.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/description/described_verb.hpp"

namespace autoref::app {

struct Proposal {
  std::string word;   // replaces the last word; if it ends with '.' or '=', it can be continued
  std::string about;  // may be empty
};

// Proposals for the last of `words` (the words after the program's name): verbs, options, or values
// if they are known. Returns at most 200 proposals, or none if the word can be any file.
std::vector<Proposal> proposals_for(const DescribedVerb& program,
                                    const std::vector<std::string>& words);

// A value to be completed.
struct ValuePlace {
  // The kind of value, as named in the help: "BOOK", "KEY=VALUE", "GAME_ID".
  std::string kind;
  std::string begun;                     // the part typed so far
  std::vector<std::string> positionals;  // the preceding arguments without dashes
};

// Values of that kind that begin with `begun`; empty for an unknown kind.
std::vector<Proposal> values_at(const ValuePlace& place);

// Sorted ids of the games in a results folder that begin with `begun`. Returns at most 200 ids, and
// reads only the first megabytes of the folder's files.
std::vector<std::string> stored_ids(const std::filesystem::path& folder, const std::string& begun);

// Prints the proposals for `autoref complete WORD ...`, one per line: the word, a tab and the
// description.
int complete_verb(const DescribedVerb& program, const std::vector<std::string>& words);

}  // namespace autoref::app
