#include "benchmarks/live_punctuality.hpp"

#include <fmt/format.h>

#include <chrono>

#include "benchmarks/beside_live_game.hpp"
#include "live/simulator/live_game.hpp"

namespace autoref::benchmarks {
namespace {

using LiveClock = std::chrono::steady_clock;

constexpr double kPacketRate_hz = 60;

game::GameConfiguration measured_configuration(double seconds, bool on_network) {
  game::GameConfiguration game;
  game.match.half_s = seconds + 1;  // so that the game does not end by itself
  for (game::TeamConfiguration* team : {&game.a, &game.b}) {
    team->strategy = on_network ? "network" : "cobalt";
    team->on_network = on_network;
  }
  return game;
}

live::Punctuality punctuality_of(const game::GameConfiguration& game,
                                 const live::LiveOptions& options, double seconds) {
  live::SteadyFrameClock clock;
  const LiveClock::time_point start = LiveClock::now();
  const auto is_over = [&] {
    return LiveClock::now() - start >= std::chrono::duration<double>(seconds);
  };
  live::LiveGame live(game, options, clock, is_over);
  game::GamePrograms programs = game::GamePrograms::live(
      game, {}, [&](const game::TeamConfiguration&, const strategies::TeamContext& context) {
        return live.make_network_team(context);
      });
  live.play(nullptr, programs);
  return live.report().punctuality;
}

MeasuredLiveGame measure_live_game(const LiveConditions& conditions, bool on_network) {
  const game::GameConfiguration game = measured_configuration(conditions.seconds, on_network);
  live::NetworkThread thread;
  FrameCounter vision(thread, vision_frame_in);
  FrameCounter tracker(thread, tracker_frame_in);
  live::LiveOptions live;
  live.unicast = live::kLoopback;
  live.ports = {};
  live.ports.vision = vision.port();
  live.ports.tracker = tracker.port();
  const std::vector<int> free = free_ports(thread, 3);
  live.ports.referee = free[0];
  live.ports.blue = free[1];
  live.ports.yellow = free[2];
  live.ports.control = live.ports.grsim = 0;
  std::optional<CommandingThread> teams;
  if (on_network) {
    teams.emplace(std::vector{live.ports.blue, live.ports.yellow},
                  static_cast<int>(game.a.robots.size()), kPacketRate_hz);
  }
  const double rate_hz = game.sim.frame_rate_hz;
  BareLoop bare(rate_hz, std::chrono::duration<double>(1 / (2 * rate_hz)));
  MeasuredLiveGame result;
  result.teams = on_network ? "network" : "compiled-in";
  result.game = punctuality_of(game, live, conditions.seconds);
  result.bare = bare.stop();
  result.received = vision.received() + tracker.received();
  result.lost = vision.lost() + tracker.lost();
  return result;
}

double late_share(const live::Punctuality& punctuality) {
  return static_cast<double>(punctuality.late) / static_cast<double>(punctuality.frames);
}

void print_loop(const char* name, const live::Punctuality& loop) {
  fmt::print("  {:<20}{:9} frames, {} more than 2 ms late, the worst {:.1f} ms\n", name,
             loop.frames, loop.late, loop.worst_ms);
}

void print(const MeasuredLiveGame& result) {
  fmt::print("{} teams\n", result.teams);
  print_loop("game", result.game);
  print_loop("bare loop", result.bare);
  const std::optional<double> ratio = result.ratio();
  fmt::print("  {:<20}{:>9}\n", "ratio", ratio ? fmt::format("{:.3f}", *ratio) : "none");
  fmt::print("  {:<20}{:9} received, {} lost\n", "vision and tracker", result.received,
             result.lost);
}

}  // namespace

std::optional<double> MeasuredLiveGame::ratio() const {
  if (bare.late == 0 || game.frames == 0) return std::nullopt;
  return late_share(game) / late_share(bare);
}

std::vector<MeasuredLiveGame> measure_live_games(const LiveConditions& conditions) {
  const BusyProcesses load(conditions.load);
  return {measure_live_game(conditions, false), measure_live_game(conditions, true)};
}

void print_live_punctuality(const LiveConditions& conditions) {
  for (const MeasuredLiveGame& game : measure_live_games(conditions)) print(game);
}

}  // namespace autoref::benchmarks
