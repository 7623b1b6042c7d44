// The columns and keys that the program writes, taken from its output.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace autoref {

using WrittenNames = std::vector<std::string>;

// One section of docs/schemas.md.
struct Artefact {
  std::string section;
  WrittenNames (*names)();  // columns in order, or sorted keys
  bool is_json = false;
};

// Prints the artefact's name when a test fails.
inline void PrintTo(const Artefact& artefact, std::ostream* out) { *out << artefact.section; }

// The columns of results.csv that count calls, one for each call of docs/reference/rules.md.
WrittenNames calls_columns();

// The names without repetitions, where the columns of all groups of possession chains have the same
// name, and likewise those of all kinds of actions: "chains_kick_off_a" becomes "chains_GROUP_a",
// and "worth_pass_a" becomes "worth_KIND_a".
WrittenNames with_general_names(const WrittenNames& names);

// Replaces the name of a group of chains, or of a kind of action, between `before` and `after`.
std::string with_general_name(std::string name, std::string_view before, std::string_view after);

std::vector<Artefact> written_csv();
std::vector<Artefact> written_plots();
std::vector<Artefact> written_json();

}  // namespace autoref
