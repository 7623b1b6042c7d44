// The functions that add the verbs to the command line.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <memory>

namespace autoref::app {

// The work requested by the command line. The function returns the exit code; errors are thrown
// (io/errors.hpp).
using Chosen = std::function<int()>;

// Sets up `verb` so that parsing it sets `chosen` to `work` with the parsed arguments.
template <typename Arguments>
void choose(CLI::App& verb, Chosen& chosen, const std::shared_ptr<Arguments>& arguments,
            int (*work)(const Arguments&)) {
  verb.callback([=, &chosen] { chosen = [=] { return work(*arguments); }; });
}

// Each of these functions adds a verb to the program or to a group. Parsing the verb sets `chosen`
// to the verb's work.
#define AUTOREF_GROUP(heading, name, about)
#define AUTOREF_VERB(group, add) void add(CLI::App& app, Chosen& chosen);
#include "app/verbs.def"
#undef AUTOREF_GROUP
#undef AUTOREF_VERB

}  // namespace autoref::app
