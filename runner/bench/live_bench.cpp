#include "runner/bench/live_bench.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "runner/bench/beside_live_game.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/json.hpp"
#include "runner/live/live_game.hpp"

namespace autoref::runner {
namespace {

using LiveBenchClock = std::chrono::steady_clock;

constexpr double kPacketRate_hz = 60;

// Thrown in the game's loop when its time is over.
struct MeasuringIsOver {};

GameConfiguration live_bench_game(double seconds, bool on_network) {
  GameConfiguration game;
  game.match.half_s = seconds + 1;  // it does not end by itself
  for (TeamConfiguration* team : {&game.a, &game.b}) {
    team->strategy = on_network ? "network" : "cobalt";
    team->on_network = on_network;
  }
  return game;
}

Punctuality punctuality_of(const GameConfiguration& game, const LiveOptions& options,
                           double seconds) {
  SteadyFrameClock clock;
  const LiveBenchClock::time_point start = LiveBenchClock::now();
  const auto check = [&] {
    if (LiveBenchClock::now() - start >= std::chrono::duration<double>(seconds))
      throw MeasuringIsOver();
  };
  LiveGame live(game, options, clock, check);
  GamePrograms programs = GamePrograms::live(
      game, {}, [&](const TeamConfiguration&, const strategies::TeamContext& context) {
        return live.make_network_team(context);
      });
  try {
    live.play(nullptr, programs);
  } catch (const MeasuringIsOver&) {
  }
  return live.report().punctuality;
}

LiveBenchGame measured(const LiveBenchOptions& options, bool on_network) {
  const GameConfiguration game = live_bench_game(options.seconds, on_network);
  NetworkThread thread;
  FrameCounter vision(thread, vision_frame_in);
  FrameCounter tracker(thread, tracker_frame_in);
  LiveOptions live;
  live.unicast = kLoopback;
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
  LiveBenchGame result;
  result.teams = on_network ? "network" : "compiled-in";
  result.game = punctuality_of(game, live, options.seconds);
  result.bare = bare.stop();
  result.received = vision.received() + tracker.received();
  result.lost = vision.lost() + tracker.lost();
  return result;
}

double late_share(const Punctuality& punctuality) {
  return static_cast<double>(punctuality.late) / static_cast<double>(punctuality.frames);
}

Json json_of(const LiveBenchGame& result) {
  Json object = {{"teams", result.teams},
                 {"frames", result.game.frames},
                 {"late", result.game.late},
                 {"worst_ms", rounded(result.game.worst_ms, 2)},
                 {"bare_frames", result.bare.frames},
                 {"bare_late", result.bare.late},
                 {"bare_worst_ms", rounded(result.bare.worst_ms, 2)},
                 {"ratio", nullptr},
                 {"received", result.received},
                 {"lost", result.lost}};
  if (const std::optional<double> ratio = result.ratio()) object["ratio"] = rounded(*ratio, 3);
  return object;
}

void print_loop(const char* name, const Punctuality& loop) {
  fmt::print("  {:<20}{:9} frames, {} more than 2 ms late, the worst {:.1f} ms\n", name,
             loop.frames, loop.late, loop.worst_ms);
}

void print(const LiveBenchGame& result) {
  fmt::print("{} teams\n", result.teams);
  print_loop("game", result.game);
  print_loop("bare loop", result.bare);
  const std::optional<double> ratio = result.ratio();
  fmt::print("  {:<20}{:>9}\n", "ratio", ratio ? fmt::format("{:.3f}", *ratio) : "none");
  fmt::print("  {:<20}{:9} received, {} lost\n", "vision and tracker", result.received,
             result.lost);
}

}  // namespace

std::optional<double> LiveBenchGame::ratio() const {
  if (bare.late == 0 || game.frames == 0) return std::nullopt;
  return late_share(game) / late_share(bare);
}

std::vector<LiveBenchGame> bench_live(const LiveBenchOptions& options) {
  const BusyProcesses load(options.load);
  return {measured(options, false), measured(options, true)};
}

int run_live_bench(const LiveBenchOptions& options, bool json) {
  const std::vector<LiveBenchGame> results = bench_live(options);
  if (!json) {
    for (const LiveBenchGame& result : results) print(result);
    return kDone;
  }
  Json games = Json::array();
  for (const LiveBenchGame& result : results) games.push_back(json_of(result));
  fmt::print("{}\n",
             json_text({{"seconds", options.seconds}, {"load", options.load}, {"games", games}}));
  return kDone;
}

}  // namespace autoref::runner
