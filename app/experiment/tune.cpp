#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_line.hpp"

namespace autoref::app {
namespace {

constexpr double kDefaultWait_s = 600;
constexpr double kLongestWait_s = 86400;

}  // namespace

int tune_verb(const RunArguments& arguments) { return run_verb(arguments); }

void add_tune_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("tune", "Improve a team's parameters by playing.");
  auto arguments = std::make_shared<RunArguments>();
  arguments->verbs = {"tune"};
  arguments->wait_s = kDefaultWait_s;
  add_run_options(*verb, *arguments);
  verb->add_option("--wait", arguments->wait_s,
                   "How long a shard waits for games of other shards, in s. Default: 600.")
      ->type_name("S")
      ->check(CLI::Range(0.0, kLongestWait_s));
  verb->footer(
      "Searches with SPSA or CMA-ES, then tests the result against the start with new games and\n"
      "says whether it is better. The folder gets tune.csv with the path of every parameter and\n"
      "result.yaml with the tuned team; autoref report draws the path.\n\n"
      "Ctrl-C lets the running games finish; a second one stops at once. The same command\n"
      "continues later, on the same path, even after kill -9. The path does not depend on the\n"
      "number of workers or shards. Shards share a folder: after each iteration, a shard waits "
      "for\n"
      "the games of the others, and exits with 75 if none arrives for the time of --wait.\n\n"
      "Example:\n  autoref tune scenarios/tune-first.yaml -o results/runs/tune -j 2");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return tune_verb(*arguments); }; });
}

}  // namespace autoref::app
