#include "app/game/controlled.hpp"

#include <fmt/format.h>

#include "app/game/play_one.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "live/controller/controlled_game.hpp"

namespace autoref::app {
namespace {

void say(const live::ControlledGameReport& report) {
  io::write_message(stderr,
                    fmt::format("AutoRef's events: {} taken, {} rejected, {} not answered\n",
                                report.accepted, report.rejected, report.unanswered));
  if (!report.problem.empty())
    io::write_message(stderr, fmt::format("The port for automatic referees: {}\n", report.problem));
  io::write_message(stderr, report.differences);
}

}  // namespace

live::Address controller_address(const std::string& text, int port) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {text, port};
  const std::optional<int> given = io::whole_number_in(text.substr(colon + 1));
  if (given && colon > 0 && *given >= 1 && *given <= 65535) return {text.substr(0, colon), *given};
  throw io::InputError({"--game-controller"}, "",
                       fmt::format("expected HOST or HOST:PORT, found '{}'", text));
}

game::GameRecord play_controlled(const game::GameConfiguration& game,
                                 const PlayArguments& arguments,
                                 const std::vector<std::string>& inputs) {
  live::ControllerPlace place;
  if (!arguments.game_controller.empty())
    place.ci = controller_address(arguments.game_controller, place.ci.port);
  live::ControlledGame controlled(game, place, check_interrupt);
  GamePlayer player;
  player.play = [&](const game::Observers& observers, game::GamePrograms& programs) {
    return controlled.play(observers, programs);
  };
  game::GameRecord record = play_one(game, arguments.output, inputs, {arguments.commands}, player);
  say(controlled.report());
  return record;
}

}  // namespace autoref::app
