// The columns and keys that the program writes, taken from its output.
#pragma once

#include <ostream>
#include <string>
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
// name: "chains_kick_off_a" becomes "chains_GROUP_a".
WrittenNames with_chain_groups(const WrittenNames& names);

std::vector<Artefact> written_csv();
std::vector<Artefact> written_plots();
std::vector<Artefact> written_json();

}  // namespace autoref
