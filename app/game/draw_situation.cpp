#include "app/game/draw_situation.hpp"

#include <fmt/format.h>

#include <optional>

#include "app/output_file.hpp"
#include "app/scenario_argument.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/situations/situations.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"
#include "view/drawing.hpp"

namespace autoref::app {
namespace {

const experiments::SituationSetup& situation_named(const experiments::Situations& situations,
                                                   const DrawArguments& arguments) {
  const auto found = situations.situations.find(arguments.situation);
  if (found != situations.situations.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [name, situation] : situations.situations) names.push_back(name);
  throw io::InputError({"--situation"}, "", game::unknown_key_message(arguments.situation, names));
}

Frame frame_of(const game::StartState& start) {
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
  const experiments::Scenario scenario = experiments::read_scenario(scenario_file);
  const auto* situations = scenario.as<experiments::Situations>();
  if (situations == nullptr) {
    throw io::InputError(
        {scenario_file}, "kind",
        fmt::format("this is of kind {}; --situation needs a scenario of kind situations",
                    experiments::kind_of(scenario)));
  }
  const experiments::SituationSetup& situation = situation_named(*situations, arguments);
  check_outputs({{"-o", arguments.output}}, {scenario_file});
  std::optional<io::PendingFile> file;
  open_output(file, "-o", arguments.output);
  const Field& field = situations->base.field;
  const game::StartState start = experiments::drawn_state(situation, arguments.situation, field,
                                                          situations->seed, arguments.scene);
  file->commit(view::drawing_of(
      {field, {{"attackers", "defenders"}}, signal_of(start.referee), {frame_of(start)}}));
  return io::kDone;
}

}  // namespace autoref::app
