#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/output_file.hpp"
#include "app/scenario_argument.hpp"
#include "app/verbs.hpp"
#include "game/lab/lab.hpp"
#include "game/settings/named_files.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

struct LabArguments {
  std::string file;
  std::string csv;  // empty: standard output
};

int lab_verb(const LabArguments& arguments) {
  const game::LabScene scene = game::read_lab_scene(arguments.file);
  std::vector<std::string> inputs = game::settings_files_in(arguments.file);
  inputs.push_back(arguments.file);
  check_outputs({{"--csv", arguments.csv}}, inputs);
  std::optional<io::PendingFile> csv;
  open_output(csv, "--csv", arguments.csv);
  const std::string text = game::csv_of(scene, game::play_lab_scene(scene));
  if (csv) {
    csv->commit(text);
  } else {
    fmt::print("{}", text);
  }
  return io::kDone;
}

}  // namespace

void add_lab_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("lab", "Simulate a small physics experiment, without teams or referee.");
  auto arguments = std::make_shared<LabArguments>();
  add_scenario_argument(*verb, arguments->file, "Scene of kind lab.");
  verb->add_option("--csv", arguments->csv, "Write the rows to FILE instead of standard output.")
      ->type_name("FILE");
  verb->footer(
      "Writes one row per camera frame: time, and position, heading and speed of every object.\n\n"
      "Example:\n  autoref experiment lab scenarios/lab/straight-kick.yaml --csv kick.csv");
  choose(*verb, chosen, arguments, lab_verb);
}

}  // namespace autoref::app
