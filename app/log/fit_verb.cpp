#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "app/log/judged_log.hpp"
#include "app/output_file.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "game/settings/named_files.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/table.hpp"
#include "io/terminal.hpp"
#include "logs/fit/fit_report.hpp"
#include "logs/fit/log_fit.hpp"
#include "logs/user_log.hpp"

namespace autoref::app {
namespace {

struct FitArguments {
  std::vector<std::string> logs;
  std::string output;     // path of the measured file; empty: none
  bool replaces = false;  // whether to replace existing files
  bool json = false;
};

// The files to write, by path.
using Files = std::map<std::string, std::string>;

std::string source_of(const std::vector<std::string>& paths) {
  const std::string first = std::filesystem::path(paths.front()).filename().string();
  const std::size_t others = paths.size() - 1;
  return others == 0 ? first
                     : fmt::format("{} and {} other{}", first, others, others == 1 ? "" : "s");
}

// "mine.yaml" for ball and vision, and "mine-TEAM.yaml" for the robots of each team.
Files files_of(const logs::LogFit& fit, const std::string& output, const std::string& source) {
  if (output.empty()) return {};
  const std::filesystem::path path = output;
  Files files{{output, logs::measured_yaml(fit, "Ball, contacts and vision of " + source + ".")}};
  for (const logs::FittedTeam& team : fit.teams) {
    const std::string name = path.stem().string() + "-" + logs::file_word(team.name);
    std::string file = (path.parent_path() / (name + path.extension().string())).string();
    for (int number = 2; files.contains(file); ++number)
      file = (path.parent_path() / fmt::format("{}-{}{}", name, number, path.extension().string()))
                 .string();
    files[file] = logs::robots_yaml(fit, team, "Robots of " + team.name + " in " + source + ".");
  }
  return files;
}

// Refuses a file whose name games would refuse.
void check_name(const std::string& output) {
  const std::filesystem::path path = output;
  if (!game::is_settings_file(output) || path.extension() != ".yaml")
    throw io::InputError({"-o"}, "", fmt::format("{}: expected a name that ends in .yaml", output));
  if (const auto fault = game::fault_in_name(path.stem().string(), game::kPreset))
    throw io::InputError({"-o"}, "", *fault);
}

void refuse_existing(const std::string& path) {
  std::error_code error;
  if (std::filesystem::exists(path, error))
    throw io::InputError({"-o"}, "", fmt::format("{} exists; replace it with --force", path));
}

void write_files(const Files& files, bool replaces) {
  for (const auto& [path, text] : files) {
    if (!replaces) refuse_existing(path);
  }
  for (const auto& [path, text] : files) io::PendingFile(path).commit(text);
}

int fit_verb(const FitArguments& arguments) {
  const std::vector<std::string> paths = logs::logs_in(arguments.logs);
  check_outputs({{"-o", arguments.output}}, paths);
  if (!arguments.output.empty()) {
    check_name(arguments.output);
    if (!arguments.replaces) refuse_existing(arguments.output);
  }
  std::vector<logs::NamedLog> named;
  std::vector<std::string> fitted;
  const int code = for_each_log(paths, [&](const std::string& path) {
    const std::string copy = logs::seekable_log(path);
    const logs::RecordedFacts facts = logs::read_facts(path, copy);
    io::write_message(stderr, logs::damage_text(path, facts.log));
    named.push_back({copy, facts.names});
    fitted.push_back(path);
    return !facts.log.damage;
  });
  if (named.empty()) return code;
  const logs::LogFit fit = logs::fit_of(named);
  if (fit.packets == 0)
    throw io::InputError({"LOG"}, "", "no vision packets: only they show what the cameras saw");
  const Files files = files_of(fit, arguments.output, source_of(fitted));
  write_files(files, arguments.replaces);
  fmt::print("{}\n", arguments.json ? logs::fit_json(fit)
                                    : io::text_of(logs::fit_text(fit), io::text_width(stdout)));
  if (!arguments.json) {
    for (const auto& [path, text] : files) fmt::print("{}\n", path);
  }
  return code;
}

}  // namespace

void add_fit_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "fit", "Estimate ball, robots and cameras of recorded games, for simulations like them.");
  auto arguments = std::make_shared<FitArguments>();
  add_logs_argument(*verb, arguments->logs);
  verb->add_option(
          "-o,--output", arguments->output,
          "File for ball, contacts and vision; the robots of a team go into a file next to "
          "it, with the team's name.")
      ->type_name("FILE");
  verb->add_flag("--force", arguments->replaces, "Replace existing files.");
  add_json_flag(*verb, arguments->json);
  verb->footer(
      "All logs are fitted together. Each number comes with its 95 % interval and the number of\n"
      "observations behind it; \"not enough\" means too few.\n\n"
      "Example:\n  autoref log fit recordings/ -o mine.yaml\n"
      "  autoref play game.yaml --set sim.ball=mine.yaml --set sim.camera=mine.yaml \\\n"
      "    --set a.type=mine-TEAM.yaml");
  choose(*verb, chosen, arguments, fit_verb);
}

}  // namespace autoref::app
