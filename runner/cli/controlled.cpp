#include "runner/cli/controlled.hpp"

#include <fmt/format.h>

#include "runner/cli/play_one.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"
#include "runner/live/controlled_game.hpp"

namespace autoref::runner {
namespace {

void say(const ControlledGameReport& report) {
  write_message(stderr, fmt::format("AutoRef's events: {} taken, {} rejected, {} not answered\n",
                                    report.accepted, report.rejected, report.unanswered));
  if (!report.problem.empty())
    write_message(stderr, fmt::format("The port for automatic referees: {}\n", report.problem));
  write_message(stderr, report.differences);
}

}  // namespace

Address controller_address(const std::string& text, int port) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {text, port};
  const std::optional<int> given = whole_number_in(text.substr(colon + 1));
  if (given && colon > 0 && *given >= 1 && *given <= 65535) return {text.substr(0, colon), *given};
  throw InputError({"--game-controller"}, "",
                   fmt::format("expected HOST or HOST:PORT, found '{}'", text));
}

GameRecord play_controlled(const GameConfiguration& game, const PlayArguments& arguments,
                           const std::vector<std::string>& inputs) {
  ControllerPlace place;
  if (!arguments.game_controller.empty())
    place.ci = controller_address(arguments.game_controller, place.ci.port);
  ControlledGame controlled(game, place, check_interrupt);
  GamePlayer player;
  player.play = [&](const Observers& observers, GamePrograms& programs) {
    return controlled.play(observers, programs);
  };
  GameRecord record = play_one(game, arguments.output, inputs, {arguments.commands}, player);
  say(controlled.report());
  return record;
}

}  // namespace autoref::runner
