// The names that verbs had before they were grouped. They still work, but help does not list them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace autoref::app {

struct FormerName {
  std::string_view former;   // "status"
  std::string_view present;  // "results status"
};

const std::vector<FormerName>& former_names();

// Replaces a former name that comes first or follows `help`. `words` are those after the program's
// name: "results status DIR" for "status DIR".
std::vector<std::string> with_present_names(std::vector<std::string> words);

}  // namespace autoref::app
