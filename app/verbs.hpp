// The functions that add the verbs to the command line.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <memory>

namespace autoref::app {

// The work that the command line asks for; returns the exit code. Errors are thrown
// (io/errors.hpp).
using Chosen = std::function<int()>;

// Makes parsing `verb`, which fills in the arguments, set `chosen` to `work` with them.
template <typename Arguments>
void choose(CLI::App& verb, Chosen& chosen, const std::shared_ptr<Arguments>& arguments,
            int (*work)(const Arguments&)) {
  verb.callback([=, &chosen] { chosen = [=] { return work(*arguments); }; });
}

// Each adds a verb to the program or to a group. Parsing the verb sets `chosen` to the verb's work.
#define AUTOREF_GROUP(heading, name, about)
#define AUTOREF_VERB(group, add) void add(CLI::App& app, Chosen& chosen);
#include "app/verbs.def"
#undef AUTOREF_GROUP
#undef AUTOREF_VERB

}  // namespace autoref::app
