#include "runner/bench.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "runner/verbs/command_line.hpp"

namespace autoref::runner {

void add_bench_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("bench", "Measure how fast whole games are.");
  auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json, "Print one JSON object.");
  verb->footer("Example:\n  autoref bench --json");
  verb->callback([json, &chosen] { chosen = [json] { return run_bench(*json); }; });
}

}  // namespace autoref::runner
