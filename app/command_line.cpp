#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/description/completion.hpp"
#include "app/former_names.hpp"
#include "app/mistyped.hpp"
#include "app/verbs.hpp"
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

std::vector<CLI::App*> all_verbs(CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

// Parses the words after the program's name and does the work that they request.
int run_parsed(CLI::App& app, std::vector<std::string> words, const Chosen& chosen) {
  try {
    std::reverse(words.begin(), words.end());  // CLI11 expects them in reverse order
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == io::kDone) return app.exit(error);
    throw io::InputError({}, "", message_of(app, error));
  }
  return chosen();
}

// Finds the group with this name; the program itself if the name is empty.
CLI::App& group_of(CLI::App& app, const std::string& name) {
  return name.empty() ? app : *app.get_subcommand(name);
}

void add_group(CLI::App& app, const char* heading, const char* name, const char* about) {
  app.add_subcommand(name, about)->require_subcommand(1)->group(heading);
}

// Adds the verbs to the description: "Examine a recorded game: info, draw."
void describe(CLI::App& group) {
  std::vector<std::string> names;
  for (const CLI::App* verb : all_verbs(group)) names.push_back(verb->get_name());
  group.description(fmt::format("{}: {}.", group.get_description(), fmt::join(names, ", ")));
  group.footer(fmt::format("`autoref help {} VERB` explains a verb.", group.get_name()));
}

void add_verbs(CLI::App& app, Chosen& chosen) {
  app.get_formatter()->label("SUBCOMMAND", "VERB");
  app.group("Verbs");  // the heading that verbs inherit
#define AUTOREF_GROUP(heading, name, about) add_group(app, heading, name, about);
#define AUTOREF_VERB(group, add) add(group_of(app, group), chosen);
#include "app/verbs.def"
#undef AUTOREF_GROUP
#undef AUTOREF_VERB
  for (CLI::App* verb : all_verbs(app)) {
    for (CLI::App* nested : all_verbs(*verb))
      if (!nested->get_group().empty()) nested->group(app.get_group());
    if (!all_verbs(*verb).empty()) describe(*verb);
  }
}

}  // namespace

int exit_code_of(const std::function<int()>& work, std::string_view program) {
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
      "Simulates and referees robot soccer games of the RoboCup Small Size League, and plays\n"
      "hundreds of games to find out which team, or which handicap, wins.",
      "autoref");
  app.set_version_flag("--version", fmt::format("autoref {}", io::build_id()));
  app.require_subcommand(1);
  app.footer(
      "`autoref help VERB` explains a verb or a group.\n\n"
      "Example, an experiment of 36 games:\n  autoref run scenarios/first-look.yaml\n\n"
      "A scenario that is not in the current folder is looked up among the installed ones, in\n"
      "share/autoref next to the program's bin folder.\n\n"
      "Exit codes: 0 done; 2 bad input; 3 too many void games; 4 a replayed game differs;\n"
      "70 internal error; 74 input/output error; 75 interrupted (repeat the command to continue).");
  Chosen chosen;
  add_verbs(app, chosen);
  const std::vector<std::string> given(argv + std::min(argc, 1), argv + argc);
  // `complete` is not a normal verb: the scripts of `autoref show completion` call it with
  // arbitrary words.
  if (!given.empty() && given.front() == "complete") {
    return exit_code_of([&] {
      return complete_verb(described(app), {given.begin() + 1, given.end()});
    });
  }
  const std::vector<std::string> words =
      given.empty() ? std::vector<std::string>{"help"} : with_present_names(given);
  if (!words.front().starts_with('-') && !is_verb(app, words.front()))
    return fail("autoref", io::kBadInput, unknown_verb_message(app, words.front()));
  return exit_code_of([&] { return run_parsed(app, words, chosen); });
}

}  // namespace autoref::app
