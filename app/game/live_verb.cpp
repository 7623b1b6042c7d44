#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "app/game/play_one.hpp"
#include "app/game/scenario_game.hpp"
#include "app/network_flags.hpp"
#include "app/scenario_argument.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "live/controller/controller_client.hpp"
#include "live/simulator/live_game.hpp"
#include "logs/user_log.hpp"
#include "soccer/side.hpp"

namespace autoref::app {
namespace {

struct LiveArguments {
  std::string file;
  std::string seed;               // empty: the scenario's seed
  std::vector<std::string> sets;  // "key=value"
  std::string speed = "1";        // a factor, "max" or "lockstep"
  live::LiveOptions options;      // options except the speed
  bool broadcasts = false;        // broadcast instead of sending to multicast groups
  std::string control;            // who commands the game; empty: as in the scenario
  std::string game_controller;    // auto or HOST[:PORT]; empty: the default
  GameOutput output;
};

live::LiveSpeed speed_of(const std::string& text) {
  if (text == "max") return {live::Pace::kPackets};
  if (text == "lockstep") return {live::Pace::kLockStep};
  return {live::Pace::kClock, speed_factor_in(text, "max or lockstep")};
}

void print_traffic(Side side, const live::LiveReport& report) {
  const live::TeamTraffic& traffic = report.traffic[side];
  const std::array<std::int64_t, 3>& ages = report.command_ages[side];
  const std::int64_t frames = ages[0] + ages[1] + ages[2];
  if (frames == 0) return;
  const double recent = static_cast<double>(ages[0] + ages[1]) / static_cast<double>(frames);
  io::write_message(
      stderr,
      fmt::format("{}: {} packets, {} invalid, {} from another computer; commands at most one "
                  "frame old in {:.1f} % of the frames\n",
                  colour_of(side), traffic.packets, traffic.wrong, traffic.foreign, 100 * recent));
  if (traffic.absent > 0) {
    io::write_message(
        stderr, fmt::format("{}: {} commands for robots that the team does not have (first: {})\n",
                            colour_of(side), traffic.absent, traffic.first_absent));
  }
  if (!traffic.last_error.empty())
    io::write_message(stderr,
                      fmt::format("{}: last error: {}\n", colour_of(side), traffic.last_error));
}

void print_connections(const live::StreamTroubles& troubles) {
  if (troubles.refused + troubles.invalid + troubles.unread == 0) return;
  io::write_message(
      stderr,
      fmt::format("TCP: {} connections above the limit were refused; {} were closed after an "
                  "invalid message, {} because responses were not read\n",
                  troubles.refused, troubles.invalid, troubles.unread));
}

void print_controller(const live::FollowedControllerReport& report) {
  for (const std::string& fault : logs::texts_of(report.faults))
    io::write_message(stderr, fmt::format("autoref: {}\n", fault));
  io::write_message(stderr,
                    fmt::format("game controller: {}\n", live::controller_line(report.status)));
  io::write_message(stderr, report.differences);
}

void print_report(const live::LiveReport& report) {
  const live::Punctuality& punctuality = report.punctuality;
  if (punctuality.frames > 0) {
    io::write_message(
        stderr, fmt::format("{} frames, {} of them more than 2 ms late, the worst {:.1f} ms\n",
                            punctuality.frames, punctuality.late, punctuality.worst_ms));
  }
  if (report.dropped > 0)
    io::write_message(stderr, fmt::format("{} datagrams could not be sent\n", report.dropped));
  print_connections(report.connections);
  if (report.wrong_control > 0)
    io::write_message(stderr,
                      fmt::format("control port: {} invalid packets\n", report.wrong_control));
  for (const Side side : kSides) print_traffic(side, report);
  if (report.controller) print_controller(*report.controller);
}

void add_network_options(CLI::App& verb, LiveArguments& arguments) {
  live::LiveOptions& options = arguments.options;
  const auto port = [&verb](const char* flag, int& number, const char* about) {
    verb.add_option(flag, number, about)->type_name("PORT")->check(CLI::Range(0, 65535));
  };
  verb.add_option("--interface", options.interface,
                  "Address of the network interface to use; by default nothing leaves this "
                  "computer.")
      ->type_name("ADDRESS");
  CLI::Option* unicast =
      verb.add_option("--unicast", options.unicast,
                      "Send vision, referee and tracker packets to this host instead of the "
                      "multicast groups.")
          ->type_name("HOST");
  verb.add_flag("--broadcast", arguments.broadcasts,
                "Send these packets to all hosts of the interface's network, if it does not "
                "forward multicast.")
      ->excludes(unicast);
  verb.add_option("--control", arguments.control,
                  "Who commands the game: AutoRef, or the league's game controller on the network; "
                  "by default as in the scenario (match.control).")
      ->type_name("autoref|game-controller")
      ->check(one_of({"autoref", "game-controller"}));
  verb.add_option("--game-controller", arguments.game_controller,
                  "Where the game controller in command takes AutoRef's calls (port 10007); auto, "
                  "the default: the computer that sends the referee packets.")
      ->type_name("auto|HOST[:PORT]");
  port("--vision-port", options.ports.vision, "Port for vision packets, 10006 by default.");
  port("--referee-port", options.ports.referee, "Port for referee packets, 10003 by default.");
  port("--tracker-port", options.ports.tracker, "Port for tracker packets, 10010 by default.");
  port("--yellow-port", options.ports.yellow,
       "Port for the yellow team's commands, 10302 by default.");
  port("--blue-port", options.ports.blue, "Port for the blue team's commands, 10301 by default.");
  port("--control-port", options.ports.control,
       "Port for controlling the simulator, 10300 by default; 0: none, as in tournaments.");
  port("--grsim-port", options.ports.grsim,
       "Port for both teams' commands in grSim's packets, 20011 by default; 0: none.");
  verb.add_option("--lapse", options.lapse_s,
                  "Seconds after which a robot stops unless it gets a new command, 0.1 by default.")
      ->type_name("S")
      ->check(CLI::Range(0.0, 3600.0));
  verb.add_option("--answer", options.answer_s,
                  "With --speed max or lockstep: the longest wait for a team in seconds, 10 by "
                  "default.")
      ->type_name("S")
      ->check(CLI::Range(0.0, 3600.0));
}

// `control`: who commands the game.
live::LiveOptions options_of(const LiveArguments& arguments, referee::Control control) {
  live::LiveOptions options = arguments.options;
  options.speed = speed_of(arguments.speed);
  if (arguments.broadcasts) options.unicast = broadcast_of(options.interface);
  const bool is_controlled = control == referee::Control::kGameController;
  if (is_controlled && options.speed.pace != live::Pace::kClock) {
    throw io::InputError({"--speed"}, "",
                         fmt::format("the game controller's clock cannot follow {}; give a factor, "
                                     "usually 1",
                                     arguments.speed));
  }
  if (arguments.game_controller.empty()) return options;
  if (!is_controlled) {
    throw io::InputError({"--game-controller"}, "",
                         "AutoRef commands the game; give --control game-controller as well");
  }
  options.controller = event_address(arguments.game_controller);
  return options;
}

int live_verb(const LiveArguments& arguments) {
  const game::Assignments assignments = game::assignments_in(arguments.sets);
  game::GameSettings settings = game_in(arguments.file, arguments.seed, assignments);
  if (!arguments.control.empty())
    game::assign({"--control", "match.control", arguments.control}, settings);
  const game::GameConfiguration game = game::resolved(settings);
  const live::LiveOptions options = options_of(arguments, game.match.control);
  live::SteadyFrameClock clock;
  live::LiveGame live(game, options, clock, is_interrupted);
  GamePlayer player;
  player.make_network_team = [&](const game::TeamConfiguration&,
                                 const strategies::TeamContext& context) {
    return live.make_network_team(context);
  };
  player.play = [&](const game::Observers& observers, game::GamePrograms& programs) {
    return live.play(observers, programs);
  };
  game::GameRecord record;
  try {
    game::locate_errors(arguments.file, [&] {
      record =
          play_one(game, arguments.output, inputs_of(arguments.file, "", assignments), {}, player);
    });
  } catch (const io::Interrupted&) {
    print_report(live.report());
    throw;
  }
  print_report(live.report());
  return record.status == game::Status::kVoid ? io::kTooManyVoid : io::kDone;
}

}  // namespace

void add_live_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("live", "Play one refereed game on the league's network, in real time.");
  auto arguments = std::make_shared<LiveArguments>();
  add_scenario_argument(*verb, arguments->file, "Scenario of kind game.");
  verb->add_option("--seed", arguments->seed, "Seed, overriding the scenario.")->type_name("N");
  add_set_option(*verb, arguments->sets);
  verb->add_option("--speed", arguments->speed,
                   "Speed relative to real time, 1 by default; max: as fast as the teams answer; "
                   "lockstep: paced by the teams' SimulationSyncRequests.")
      ->type_name("FACTOR|max|lockstep");
  add_network_options(*verb, *arguments);
  add_output_options(*verb, arguments->output);
  verb->footer(
      "A team with the strategy network takes its commands from packets of the league's\n"
      "simulation protocol or of grSim. Yellow is west.\n\n"
      "Examples:\n  autoref live scenarios/paper-game.yaml --set a.strategy=network\n"
      "  autoref live scenarios/paper-game.yaml --set a.strategy=network --control "
      "game-controller");
  choose(*verb, chosen, arguments, live_verb);
}

}  // namespace autoref::app
