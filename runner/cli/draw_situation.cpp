#include "runner/cli/draw_situation.hpp"

#include <fmt/format.h>

#include <optional>

#include "runner/cli/output_file.hpp"
#include "runner/cli/scenario_argument.hpp"
#include "runner/experiments/kinds/scenario_reader.hpp"
#include "runner/experiments/kinds/situations/situations.hpp"
#include "runner/io/errors.hpp"
#include "runner/settings/fields.hpp"
#include "runner/view/drawing.hpp"

namespace autoref::runner {
namespace {

const SituationSetup& situation_named(const Situations& situations,
                                      const DrawArguments& arguments) {
  const auto found = situations.situations.find(arguments.situation);
  if (found != situations.situations.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [name, situation] : situations.situations) names.push_back(name);
  throw InputError({"--situation"}, "", unknown_key_message(arguments.situation, names));
}

Frame frame_of(const StartState& start) {
  Frame frame;
  for (const Side side : kSides) {
    for (const sim::RobotState& robot : start.robots[side])
      frame.robots[side].push_back({robot.number, robot.position_m, robot.heading});
  }
  frame.ball = BallObservation{start.ball.position_m, start.ball.height_m};
  return frame;
}

RefereeSignal signal_of(const referee::Beginning& beginning) {
  RefereeSignal signal;
  signal.stage = Stage::kFirstHalf;
  signal.command = beginning.restart.value_or(Command{CommandKind::kForceStart, Side::kWest});
  return signal;
}

}  // namespace

int draw_situation(const DrawArguments& arguments) {
  const std::string scenario_file = scenario_to_read(arguments.log);
  const Scenario scenario = read_scenario(scenario_file);
  const auto* situations = scenario.as<Situations>();
  if (situations == nullptr) {
    throw InputError(
        {scenario_file}, "kind",
        fmt::format("this is of kind {}; --situation needs a scenario of kind situations",
                    kind_of(scenario)));
  }
  const SituationSetup& situation = situation_named(*situations, arguments);
  check_outputs({{"-o", arguments.output}}, {scenario_file});
  std::optional<PendingFile> file;
  open_output(file, "-o", arguments.output);
  const Field& field = situations->base.field;
  const StartState start =
      drawn_state(situation, arguments.situation, field, situations->seed, arguments.scene);
  file->commit(drawing_of(
      {field, {{"attackers", "defenders"}}, signal_of(start.referee), {frame_of(start)}}));
  return kDone;
}

}  // namespace autoref::runner
