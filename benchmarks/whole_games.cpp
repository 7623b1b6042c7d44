#include "benchmarks/whole_games.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <vector>

#include "benchmarks/bare_box2d_benchmark.hpp"
#include "experiments/statistics/sample.hpp"
#include "game/loop/game.hpp"
#include "game/loop/state_hash.hpp"
#include "soccer/rules/rule_book.hpp"
#include "strategies/registry.hpp"

namespace autoref::benchmarks {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array<std::string_view, game::kPhaseCount> kPhaseNames = {
    "camera", "referee", "team_west", "team_east", "physics", "record"};

double ns_since(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

// A game in which every rule of every rule book is in force.
game::GameConfiguration game_with_all_rules(const std::string& team) {
  game::GameConfiguration game = game::fixed_game(0, team);
  game.match.rules = *find_rule_book("2014");
  for (const RuleEntry& entry : rule_table()) game.match.rules.in_force[entry.rule] = true;
  return game;
}

// Adds up the duration of each phase over all frames.
class Shares final : public game::Observer {
 public:
  void on_phase(game::Phase ended) override {
    const Clock::time_point now = Clock::now();
    ns_[static_cast<std::size_t>(ended)] +=
        std::chrono::duration<double, std::nano>(now - last_).count();
    last_ = now;
  }

  double ns_of(game::Phase phase) const { return ns_[static_cast<std::size_t>(phase)]; }

  std::array<double, game::kPhaseCount> shares() const {
    double sum = 0;
    for (const double ns : ns_) sum += ns;
    std::array<double, game::kPhaseCount> shares{};
    for (int i = 0; i < game::kPhaseCount; ++i) shares[i] = ns_[i] / sum;
    return shares;
  }

 private:
  Clock::time_point last_ = Clock::now();
  std::array<double, game::kPhaseCount> ns_{};
};

double bare_ns(std::uint64_t seed, std::int64_t frames) {
  BareBox2dBenchmark bare(seed);
  const Clock::time_point start = Clock::now();
  for (std::int64_t i = 0; i < frames; ++i) bare.step_frame();
  const double ns = ns_since(start);
  // The check uses the result, so that the compiler cannot remove the work. It also fails if the
  // result is NaN.
  if (!(bare.checksum_m() < 1e9)) throw std::logic_error("the bare Box2D benchmark has diverged");
  return ns;
}

constexpr double kTimedHalf_s = 300;  // two halves contain about 72000 decisions

struct Decisions {
  double ns = 0;
  std::int64_t count = 0;
};

// Wraps another strategy and times its decisions.
class Timed final : public strategies::Strategy {
 public:
  Timed(std::unique_ptr<strategies::Strategy> team, Decisions& decisions)
      : team_(std::move(team)), decisions_(decisions) {}

  void decide(const TeamView& view, TeamCommands& commands) override {
    const Clock::time_point start = Clock::now();
    team_->decide(view, commands);
    decisions_.ns += std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    ++decisions_.count;
  }
  TeamRequests requests() const override { return team_->requests(); }

 private:
  std::unique_ptr<strategies::Strategy> team_;
  Decisions& decisions_;
};

}  // namespace

WholeGames measure_whole_games(const std::string& team) {
  std::vector<double> game_ns, bare_frame_ns, ratios;
  game::StateHash signature;
  for (int i = 0; i < game::kFixedGames; ++i) {
    const game::GameConfiguration game = game::fixed_game(i, team);
    const Clock::time_point start = Clock::now();
    const game::GameRecord record = game::play(game);
    const auto frames = static_cast<double>(record.frames);
    game_ns.push_back(ns_since(start) / frames);
    bare_frame_ns.push_back(bare_ns(game.seed, record.frames) / frames);
    ratios.push_back(game_ns.back() / bare_frame_ns.back());
    signature.add(record.state_hash);
  }
  // The phases are measured in separate games, since reading the clock in every phase takes time.
  Shares shares;
  game::play(game::fixed_game(0, team), &shares);
  Shares with_all_rules;
  const game::GameRecord refereed = game::play(game_with_all_rules(team), &with_all_rules);

  WholeGames result;
  result.ns_per_frame = experiments::median(game_ns);
  result.bare_ns_per_frame = experiments::median(bare_frame_ns);
  result.ratio = experiments::median(ratios);
  result.x_real_time = 1e9 / game::GameConfiguration{}.sim.frame_rate_hz / result.ns_per_frame;
  result.signature = signature.value();
  result.shares = shares.shares();
  result.referee_ns_per_frame =
      with_all_rules.ns_of(game::Phase::kReferee) / static_cast<double>(refereed.frames);
  return result;
}

TeamCost cost_of_team(std::string_view name) {
  game::GameConfiguration game = game::fixed_game(0, std::string(name));
  game.match.half_s = kTimedHalf_s;
  Decisions decisions;
  const game::GameRecord record = game::play(
      game, nullptr,
      [&decisions](const game::TeamConfiguration& team, const strategies::TeamContext& b) {
        return std::make_unique<Timed>(game::make_registered_team(team, b), decisions);
      });
  if (record.status == game::Status::kVoid) {
    throw std::logic_error(fmt::format("{} against itself: {}", name, record.void_reason));
  }
  return {std::string(name), decisions.ns / static_cast<double>(decisions.count), decisions.count};
}

void print_whole_games(const Options& options) {
  const WholeGames r = measure_whole_games(options.team());
  fmt::print("a whole game          {:9.0f} ns per frame, {:.0f} x real time on one core\n",
             r.ns_per_frame, r.x_real_time);
  fmt::print("the bare Box2D scene  {:9.0f} ns per frame\n", r.bare_ns_per_frame);
  fmt::print("the referee           {:9.0f} ns per frame, with every rule in force\n",
             r.referee_ns_per_frame);
  fmt::print("ratio                 {:9.3f}   (median of {} rounds)\n", r.ratio, game::kFixedGames);
  fmt::print("signature             {:016x}\n", r.signature);
  for (int i = 0; i < game::kPhaseCount; ++i)
    fmt::print("  {:10} {:5.1f} %\n", kPhaseNames[i], 100 * r.shares[i]);
  if (options.strong) return;
  for (const strategies::Entry& entry : strategies::all_strategies()) {
    const TeamCost cost = cost_of_team(entry.name);
    fmt::print("team {:16} {:9.2f} us per decision\n", cost.name, cost.ns_per_decision / 1000);
  }
}

}  // namespace autoref::benchmarks
