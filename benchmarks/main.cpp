// The program `benchmarks`, with one verb for each kind of measurement (README.md).
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "app/command_line.hpp"
#include "benchmarks/build_comparison.hpp"
#include "benchmarks/experiment_costs.hpp"
#include "benchmarks/frame_costs.hpp"
#include "benchmarks/live_punctuality.hpp"
#include "benchmarks/options.hpp"
#include "benchmarks/program_costs.hpp"
#include "benchmarks/whole_games.hpp"
#include "io/errors.hpp"

namespace autoref::benchmarks {
namespace {

struct Arguments {
  Options options;
  LiveConditions live;
  std::string before;
  std::string after;
};

std::string this_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

// The `autoref` program that was built together with this one.
std::string autoref() {
  return (std::filesystem::path(this_program()).parent_path() / "autoref").string();
}

void add_strong(CLI::App& verb, Arguments& arguments) {
  verb.add_flag("--strong", arguments.options.strong,
                "Games of the strongest team against itself, instead of the default team's.");
}

void add_rounds(CLI::App& verb, Arguments& arguments) {
  verb.add_option("--rounds", arguments.options.rounds, "Number of rounds.")
      ->type_name("N")
      ->check(CLI::Range(kFewestRounds, 10000))
      ->capture_default_str();
}

void add_games(CLI::App& app, Arguments& arguments) {
  CLI::App* verb =
      app.add_subcommand("games", "Compare whole games with a bare Box2D scene of the same size.");
  add_strong(*verb, arguments);
  verb->callback([&arguments] { print_whole_games(arguments.options); });
}

void add_builds(CLI::App& app, Arguments& arguments) {
  CLI::App* verb = app.add_subcommand("builds", "Compare two builds of the program `autoref`.");
  verb->add_option("BEFORE", arguments.before, "The earlier build: a program `autoref`.")
      ->required();
  verb->add_option("AFTER", arguments.after,
                   "The later build; by default, the program beside this one.");
  add_strong(*verb, arguments);
  add_rounds(*verb, arguments);
  verb->callback([&arguments] {
    const std::string after = arguments.after.empty() ? autoref() : arguments.after;
    print_build_comparison(arguments.before, after, arguments.options);
  });
}

void add_frames(CLI::App& app, Arguments& arguments) {
  CLI::App* verb = app.add_subcommand(
      "frames", "Measure how the cost of a frame grows with robots, cameras and camera presets.");
  add_strong(*verb, arguments);
  add_rounds(*verb, arguments);
  verb->callback([&arguments] { print_frame_costs(arguments.options); });
}

void add_experiments(CLI::App& app, Arguments& arguments) {
  CLI::App* verb = app.add_subcommand(
      "experiments",
      "Measure what experiments cost besides frames: start, rows, short games, workers.");
  add_rounds(*verb, arguments);
  verb->callback([&arguments] { print_experiment_costs(autoref(), arguments.options.rounds); });
}

void add_programs(CLI::App& app) {
  app.add_subcommand("programs", "Compare games between programs with bare pipes.")->callback([] {
    print_program_costs({this_program(), "answer"});
  });
  // A hidden verb: the team program in the games of program_costs.hpp.
  app.add_subcommand("answer")->group("")->callback([] { std::exit(answer_frames()); });
}

void add_live(CLI::App& app, Arguments& arguments) {
  CLI::App* verb = app.add_subcommand(
      "live", "Compare the late frames of live games with those of a loop that only sleeps.");
  verb->add_option("--seconds", arguments.live.seconds, "Duration of each of the two games.")
      ->type_name("S")
      ->check(CLI::Range(1.0, 86400.0))
      ->capture_default_str();
  verb->add_option("--load", arguments.live.load, "Processes that compute all the time.")
      ->type_name("N")
      ->check(CLI::Range(0, 64))
      ->capture_default_str();
  verb->callback([&arguments] { print_live_punctuality(arguments.live); });
}

int run(int argc, char** argv) {
  CLI::App app("Measures the speed of AutoRef.", "benchmarks");
  app.require_subcommand(1);
  Arguments arguments;
  add_games(app, arguments);
  add_builds(app, arguments);
  add_frames(app, arguments);
  add_experiments(app, arguments);
  add_programs(app);
  add_live(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Error& error) {
    return app.exit(error) == 0 ? io::kDone : io::kBadInput;
  }
  return io::kDone;
}

}  // namespace
}  // namespace autoref::benchmarks

int main(int argc, char** argv) {
  return autoref::app::exit_code_of([&] { return autoref::benchmarks::run(argc, argv); },
                                    "benchmarks");
}
