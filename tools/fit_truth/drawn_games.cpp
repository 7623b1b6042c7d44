#include "tools/fit_truth/drawn_games.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

#include "game/loop/game.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/log_recorder.hpp"
#include "game/settings/fields.hpp"
#include "soccer/random.hpp"

namespace autoref::tools {
namespace {

constexpr double kLength_s = 600;
constexpr double kTarget = 0.05;
constexpr double kNoiseTarget = 0.1;  // also for what is missed
constexpr double kBounceTarget = 0.2;

constexpr Drawn kOfGame[] = {
    {"sim.ball.slide_mps2", 2.6, 5, kTarget, Shown::kAlways},
    {"sim.ball.roll_mps2", 0.2, 0.45, kTarget, Shown::kAlways},
    {"sim.ball.roll_per_s", 0.02, 0.08, kTarget, Shown::kAlways},
    {"sim.ball.switch_ratio", 0.6, 0.72, kTarget, Shown::kAlways},
    {"sim.ball.hop_first_xy", 0.6, 0.85, kTarget, Shown::kNotAlways},
    {"sim.ball.hop_first_z", 0.4, 0.65, kTarget, Shown::kNotAlways},
    {"sim.ball.hop_later_xy", 0.8, 0.95, kTarget, Shown::kNotAlways},
    {"sim.contacts.wall_restitution", 0.2, 0.6, kBounceTarget, Shown::kNotAlways},
    {"sim.contacts.body_restitution", 0.35, 0.7, kBounceTarget, Shown::kNotAlways},
    {"sim.kicker.direction_noise_deg", 1, 4, kNoiseTarget, Shown::kNotAlways},
    {"sim.kicker.chip_angle_deg", 38, 52, kTarget, Shown::kNotAlways},
    {"sim.kicker.chip_angle_noise_deg", 1, 7, kNoiseTarget, Shown::kNotAlways},
    {"sim.frame_rate_hz", 55, 95, kTarget, Shown::kAlways},
    {"sim.vision.ball_noise_m", 0.0004, 0.0016, kNoiseTarget, Shown::kAlways},
    {"sim.vision.robot_noise_m", 0.0003, 0.0015, kNoiseTarget, Shown::kAlways},
    {"sim.vision.robot_noise_rad", 0.003, 0.012, kNoiseTarget, Shown::kAlways},
    {"sim.vision.ball_misses", 0.005, 0.06, kNoiseTarget, Shown::kAlways},
    {"sim.vision.ball_misses_near_robots", 0.08, 0.4, kNoiseTarget, Shown::kAlways},
    {"sim.vision.near_robots_m", 0.06, 0.2, kNoiseTarget, Shown::kAlways},
    {"sim.vision.robot_misses", 0.003, 0.02, kNoiseTarget, Shown::kAlways},
    {"sim.vision.robot_gaps", 0.003, 0.02, kNoiseTarget, Shown::kAlways},
    {"sim.vision.robot_gap_s", 0.06, 0.2, kNoiseTarget, Shown::kAlways},
    {"sim.vision.false_balls_per_s", 0.005, 0.03, kNoiseTarget, Shown::kAlways},
};
// Of logs with more than one camera. One game only shows the error at the seams.
constexpr Drawn kOfCameras = {"sim.vision.camera_error_m", 0.005, 0.015, 0, Shown::kNotAlways};
// Of each team's robots. What they reach is a lower bound, so it has no target.
constexpr Drawn kOfRobots[] = {{"robot.speed_mps", 1.8, 3.2, 0, Shown::kAlways},
                               {"robot.acceleration_mps2", 2, 4, 0, Shown::kAlways},
                               {"robot.braking_mps2", 3.5, 6, 0, Shown::kAlways},
                               {"robot.angular_speed_radps", 8, 16, 0, Shown::kAlways},
                               {"robot.angular_acceleration_radps2", 25, 50, 0, Shown::kAlways}};

// Field, rules and cameras of the logs, in turn.
struct Surroundings {
  const char* book;
  const char* camera;
};
constexpr Surroundings kSurroundings[] = {
    {"2026-b", "rc2026-b"}, {"2014", "realistic"}, {"2026-b", "rc2026-b"}, {"2026-a", "rc2026-a"}};
const std::vector<std::string> kOpponents = {"cobalt", "counter", "possession", "basic"};

void draw(const Drawn& drawn, const std::string& prefix, RandomStream& random,
          game::GameSettings& game) {
  const double value = drawn.low + random.uniform() * (drawn.high - drawn.low);
  game::set_by_path(game, prefix + std::string(drawn.path), fmt::format("{}", value));
}

const Drawn* find_drawn(std::span<const Drawn> all, const std::string& path) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Drawn& one) { return one.path == path; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

game::GameSettings drawn_game(std::size_t number, std::uint64_t seed) {
  game::GameSettings game;
  const Surroundings& around = kSurroundings[number % std::size(kSurroundings)];
  game::set_by_path(game, "match.rules", around.book);
  game::set_by_path(game, "sim.camera", around.camera);
  game.seed = mix_bits(mix_bits(seed) + number);
  game.a.strategy = "cobalt";
  game.b.strategy = kOpponents[(number + number / std::size(kSurroundings)) % kOpponents.size()];
  RandomStream random(game.seed);
  game::set_by_path(game, "match.placement", random.uniform() < 0.5 ? "teams" : "simulator");
  for (const Drawn& drawn : kOfGame) draw(drawn, "", random, game);
  if (game.sim.vision.cameras > 1) draw(kOfCameras, "", random, game);
  for (const char* team : {"a.", "b."}) {
    for (const Drawn& drawn : kOfRobots) draw(drawn, team, random, game);
  }
  return game;
}

void write_log(const game::GameSettings& settings, const std::string& log) {
  const game::GameConfiguration game = game::resolved(settings);
  game::LogRecorder recorder(log, game);
  game::Game played(game, &recorder);
  const auto frames = static_cast<std::int64_t>(kLength_s * game.sim.frame_rate_hz);
  std::int64_t frame = 0;
  while (frame < frames && played.step()) ++frame;
  recorder.close();
}

const Drawn* drawn_of_game(const std::string& path, const game::GameSettings& game) {
  if (path == kOfCameras.path && game.sim.vision.cameras > 1) return &kOfCameras;
  return find_drawn(kOfGame, path);
}

const Drawn* drawn_of_robots(const std::string& path) { return find_drawn(kOfRobots, path); }

}  // namespace autoref::tools
