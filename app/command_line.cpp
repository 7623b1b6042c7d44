#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <exception>

#include "app/description/completion.hpp"
#include "app/mistyped.hpp"
#include "app/program.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"
#include "league/log_file.hpp"

namespace autoref::app {
namespace {

constexpr const char* kNoOutput = "cannot write the output";

int fail(std::string_view program, io::ExitCode code, std::string_view message) {
  io::write_message(stderr, fmt::format("{}: {}\n", program, message));
  return code;
}

// Parses the arguments, which chooses the work to do, and does it.
int run_parsed(CLI::App& app, int argc, const char* const* argv, const Chosen& chosen) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == io::kDone) return app.exit(error);
    throw io::InputError({}, "", message_of(app, error));
  }
  return chosen();
}

}  // namespace

int exit_code_of(const Chosen& work, std::string_view program) {
  try {
    const int code = work();
    // A full disk may go unnoticed until this flush, or an earlier unchecked write may have failed.
    if (std::fflush(stdout) != 0) throw io::io_error(kNoOutput, errno);
    if (std::ferror(stdout) != 0) throw io::InputOutputError(kNoOutput);
    return code;
  } catch (const io::InputError& error) {
    return fail(program, io::kBadInput, error.what());
  } catch (const league::LogError& error) {
    return fail(program, io::kInputOutput, error.what());
  } catch (const io::Interrupted& error) {
    return fail(program, io::kInterrupted, error.what());
  } catch (const std::exception& error) {
    if (const auto failure = io::environment_failure(error))
      return fail(program, io::kInputOutput, *failure);
    return fail(program, io::kInternal, fmt::format("internal error: {}", error.what()));
  }
}

int run_command_line(int argc, const char* const* argv) {
  CLI::App app(
      "Simulates and referees robot soccer games of the RoboCup Small Size League, and finds out\n"
      "over hundreds of games which team, or which handicap, wins.",
      "autoref");
  app.set_version_flag("--version", fmt::format("autoref {}", io::build_id()));
  app.require_subcommand(1);
  app.footer(
      "`autoref help VERB` explains a verb.\n\n"
      "Example, an experiment of 36 games:\n  autoref run scenarios/first-look.yaml\n\n"
      "A scenario that is not in the current folder is looked up among the installed ones, in\n"
      "share/autoref beside the program's folder bin.\n\n"
      "Exit codes: 0 done; 2 bad input; 3 too many void games; 4 a replayed game differs;\n"
      "70 internal error; 74 input/output error; 75 interrupted (repeat the command to continue).");
  Chosen chosen;
  add_play_verb(app, chosen);
  add_live_verb(app, chosen);
  add_run_verb(app, chosen);
  add_tune_verb(app, chosen);
  add_submit_verb(app, chosen);
  add_check_verb(app, chosen);
  add_status_verb(app, chosen);
  add_report_verb(app, chosen);
  add_verify_verb(app, chosen);
  add_replay_verb(app, chosen);
  add_export_verb(app, chosen);
  add_judge_verb(app, chosen);
  add_info_verb(app, chosen);
  add_referee_verb(app, chosen);
  add_lab_verb(app, chosen);
  add_view_verb(app, chosen);
  add_draw_verb(app, chosen);
  add_sample_size_verb(app, chosen);
  add_rules_verb(app, chosen);
  add_teams_verb(app, chosen);
  add_team_verb(app, chosen);
  add_bench_verb(app, chosen);
  add_completion_verb(app, chosen);
  add_man_verb(app, chosen);
  add_reference_verb(app, chosen);
  add_help_verb(app, chosen);
  app.get_formatter()->label("SUBCOMMAND", "VERB");
  for (CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; })) verb->group("Verbs");
  const std::string word = argc > 1 ? argv[1] : "";
  // For the scripts of `autoref completion`, which pass any words: not a verb like the others.
  if (word == "complete") {
    return exit_code_of([&] { return complete_verb(described(app), {argv + 2, argv + argc}); });
  }
  if (argc == 1) return exit_code_of([&app] { return help_verb(app, {}); });
  if (!word.starts_with('-') && !is_verb(app, word)) {
    return fail("autoref", io::kBadInput, unknown_verb_message(app, word));
  }
  return exit_code_of([&] { return run_parsed(app, argc, argv, chosen); });
}

}  // namespace autoref::app
