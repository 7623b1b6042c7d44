#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/output_file.hpp"
#include "app/scenario_argument.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/situations/situations.hpp"
#include "experiments/scenes/start_drawing.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"

namespace autoref::app {
namespace {

struct SituationArguments {
  std::string file;
  std::string situation;
  int scene = 1;
  std::string output;
};

const experiments::SituationSetup& situation_named(const experiments::Situations& situations,
                                                   const SituationArguments& arguments) {
  const auto found = situations.situations.find(arguments.situation);
  if (found != situations.situations.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [name, situation] : situations.situations) names.push_back(name);
  const std::string nearest = io::suggestion(arguments.situation, names);
  throw io::InputError({arguments.file}, "situations",
                       fmt::format("has no '{}'{} Known here: {}", arguments.situation,
                                   nearest.empty() ? ";" : nearest, io::listed(names)));
}

int situation_verb(const SituationArguments& arguments) {
  const experiments::Scenario scenario = experiments::read_scenario(arguments.file);
  const auto* situations = scenario.as<experiments::Situations>();
  if (situations == nullptr) {
    throw io::InputError(
        {arguments.file}, "kind",
        fmt::format("this file is of kind {}; expected a scenario of kind situations",
                    experiments::kind_of(scenario)));
  }
  const experiments::SituationSetup& situation = situation_named(*situations, arguments);
  check_outputs({{"-o", arguments.output}}, {arguments.file});
  std::optional<io::PendingFile> file;
  open_output(file, "-o", arguments.output);
  const Field& field = situations->base.field;
  const game::StartState start = experiments::drawn_state(situation, arguments.situation, field,
                                                          situations->seed, arguments.scene);
  file->commit(experiments::drawing_of(start, field, {{"attackers", "defenders"}}));
  return io::kDone;
}

}  // namespace

void add_situation_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "situation", "Draw the start of a scene of a situation, as SVG; the attackers are yellow.");
  auto arguments = std::make_shared<SituationArguments>();
  add_scenario_argument(*verb, arguments->file, "Scenario of kind situations.");
  verb->add_option("--situation,SITUATION", arguments->situation, "Name of the situation.")
      ->required()
      ->type_name("NAME");
  verb->add_option("--scene", arguments->scene, "Number of the scene.")
      ->type_name("N")
      ->check(CLI::Range(1, experiments::kMostPairs))
      ->capture_default_str();
  add_output_option(*verb, arguments->output, "The SVG file.");
  verb->footer(
      "Example:\n  autoref show situation scenarios/situations-attack.yaml corner -o corner.svg");
  choose(*verb, chosen, arguments, situation_verb);
}

}  // namespace autoref::app
