// The columns and keys that the program writes, from what it writes.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace autoref::runner {

using WrittenNames = std::vector<std::string>;

// One section of docs/schemas.md.
struct Artefact {
  std::string section;
  WrittenNames (*names)();  // of columns in their order, of keys sorted
  bool is_json = false;
};

// How a failed test names it.
inline void PrintTo(const Artefact& artefact, std::ostream* out) { *out << artefact.section; }

std::vector<Artefact> written_csv();
std::vector<Artefact> written_plots();
std::vector<Artefact> written_json();

}  // namespace autoref::runner
